/** Follows the server: long polls its state, and asks for the outline whenever the text changes. */

import { effect } from "@preact/signals";
import { get, Refusal } from "../api/client";
import { Latest } from "../api/latest";
import type { Outline, TypeCatalogue, StudioState } from "../api/types";
import { complain, say } from "./messages";
import { cameraMoves } from "../viewport/stage";
import { connection, documentState, outline, revision, schema, studio, take } from "./store";

const pause = (milliseconds: number) => new Promise((resolve) => setTimeout(resolve, milliseconds));
const retryAfter = 1000;

// The server answers after 20 s at the latest, news or not.
const longestSilence = 30_000;

// While the picture changes all the time, its numbers need not: what is drawn of them takes time from the picture.
const shortestPause = () => (cameraMoves.peek() ? 250 : 100);

async function followState(): Promise<never> {
  let version = -1;
  for (;;) {
    const start = performance.now();
    try {
      const state = await get<StudioState>("state", { after: version }, AbortSignal.timeout(longestSilence));
      version = state.version;
      connection.value = "open";
      const message = state.message;
      if (message && message.id !== studio.value?.message?.id) say(message.kind as "info" | "error", message.text);
      take(state);
      await pause(Math.max(0, shortestPause() - (performance.now() - start)));
    } catch (error) {
      const isRefused = error instanceof Refusal && (error.status === 401 || error.status === 403);
      connection.value = isRefused ? "refused" : "lost";
      version = -1;
      await pause(retryAfter);
    }
  }
}

/** Starts following; goes on as long as the page lives. */
export function follow(): void {
  void followState();
  effect(() => {
    if (connection.value === "open" && !schema.value) get<TypeCatalogue>("schema").then((s) => (schema.value = s), complain);
  });

  const outlines = new Latest<number>(async (r) => (outline.value = await get<Outline>("outline", { revision: r })), complain);
  effect(() => {
    if (revision.value >= 0) outlines.push(revision.value);
  });

  effect(() => {
    const doc = documentState.value;
    if (doc) document.title = `${doc.isDirty ? "• " : ""}${doc.name || "Studio"} – Studio`;
  });
}
