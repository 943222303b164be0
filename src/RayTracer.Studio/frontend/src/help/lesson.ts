/** Lessons of the primer beside their scenes. */

import { effect, signal } from "@preact/signals";
import { get, post } from "../api/client";
import type { HelpPage } from "../api/types";
import { openScene, unsavedQuestion } from "../files/commands";
import { newGesture } from "../state/edits";
import { attempt } from "../state/messages";
import { leftOpen, leftTab } from "../state/settings";
import { documentState, helpAt } from "../state/store";
import { targetOf, type Change } from "./links";

/** The page of the lesson in the left pane; "" for none. */
export const lesson = signal("");

export const isLesson = (page: string) => /^primer\/\d/.test(page);

/** The scene that a lesson is about: the first one that it links. */
async function sceneOf(page: string): Promise<string | null> {
  const { html } = await get<HelpPage>("help/page", { id: page });
  const links = new DOMParser().parseFromString(html, "text/html").querySelectorAll("a[href]");
  for (const link of links) {
    const target = targetOf(link.getAttribute("href")!);
    if (target.kind === "scene") return target.galleryId;
  }
  return null;
}

const isOpen = (scene: string) => documentState.value?.name === scene.slice(scene.lastIndexOf("/") + 1);

/** Opens the scene of a lesson, if it is not open; false where there is none, and where changes of another one are asked about first. */
async function opened(page: string): Promise<boolean> {
  const scene = await sceneOf(page);
  if (!scene) return false;
  if (isOpen(scene)) return true;
  await openScene({ galleryId: scene });
  return new Promise((done) => {
    const stop = effect(() => {
      if (!isOpen(scene) && !unsavedQuestion.value) return;
      done(isOpen(scene));
      queueMicrotask(() => stop());
    });
  });
}

/** Shows a lesson in the left pane, and its scene. */
export function readBeside(page: string): void {
  [lesson.value, leftTab.value, leftOpen.value, helpAt.value] = [page, "lesson", true, null];
  void attempt(() => opened(page));
}

/** Makes the changes that a lesson proposes, in its scene; they are one step to undo. */
export const tryChanges = (page: string, changes: Change[]) =>
  attempt(async () => {
    [lesson.value, leftTab.value, leftOpen.value, helpAt.value] = [page, "lesson", true, null];
    if (!(await opened(page))) return;
    const gesture = newGesture();
    for (const { pointer, value } of changes) await post("document/set", { pointer, value, gesture });
  });
