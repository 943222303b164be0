/** Changes of the document. All become edits of its text on the server. */

import { post } from "../api/client";
import { Latest } from "../api/latest";
import type { Json, Vec3 } from "../api/types";
import { attempt, complain } from "./messages";
import { dialog, hidden, known, locked, selected, selection } from "./store";

const page = Math.random().toString(36).slice(2, 8);
let gestures = 0;

/** A name for one gesture: all its edits are one step of undo. */
export const newGesture = () => `${page}-${++gestures}`;

interface Setting {
  pointer: string;
  value: Json;
  gesture: string;
}

const settings = new Map<string, Latest<Setting>>();

/** Sets a value. While one is on its way, only the newest of the same place waits. */
export function setValue(pointer: string, value: Json, gesture = newGesture()): void {
  let latest = settings.get(pointer);
  if (!latest) settings.set(pointer, (latest = new Latest<Setting>((s) => post("document/set", s), complain)));
  latest.push({ pointer, value, gesture });
}

/** Takes a value out of the text, so that its default counts again. */
export const resetValue = (pointer: string) => attempt(() => post("document/set", { pointer, value: null, reset: true }));

interface Choice {
  pointer?: string | null;
  pointers?: string[];
  adds?: boolean;
}

// What was chosen last may still be on its way to the server, and its state on the way back.
let choosing: Promise<void> = Promise.resolve();

/** Selects what a search finds; null for what leaves the selection as it is. What is done to the selection from here on waits for it. */
export async function choose(find: () => Promise<Choice | null>): Promise<void> {
  const search = async () => {
    const choice = await find();
    if (choice) await known((await post<{ version: number }>("select", choice)).version);
  };
  const mine = search();
  choosing = mine.catch(() => undefined);
  return mine;
}

/** Selects a thing; `adds` where it shall be selected beside others, or no longer. */
export const select = (pointer: string | null, adds = false) => attempt(() => choose(async () => ({ pointer, adds })));

/** A pixel of the picture. */
export type Pixel = [number, number];

/** Adds a thing where one looks, or at a pixel. */
export const addThing = (family: string, type: string, file?: string, at?: Pixel) =>
  attempt(() =>
    choose(async () => {
      const added = await post<{ pointer: string }>("document/add", { family, type, file, at });
      return { pointer: isThing(added.pointer) ? added.pointer : null };
    }),
  );

export const duplicate = (pointers: string[]) =>
  attempt(() => choose(async () => ({ pointers: (await post<{ pointers: string[] }>("document/duplicate", { pointers })).pointers })));

export const remove = (pointers: string[]) => attempt(() => post("document/delete", { pointers }));

/** What can be given to things: what has a name among materials and textures, and lights. */
export const isGiven = (pointer: string | null): pointer is string => pointer !== null && /^\/(materials|textures|lights)\/[^/]+$/.test(pointer);

/** Gives a material, a texture or a light to things, or to the one at a pixel. */
export const applyTo = (pointer: string, to: { things: string[] } | { at: Pixel }) => attempt(() => post("document/apply", { pointer, ...to }));

/** Gives what was selected last to the other selected things. */
export const applyToSelected = () =>
  withSelection((pointers) => {
    const what = selection.value;
    if (isGiven(what)) applyTo(what, { things: pointers.filter((p) => p !== what && /^\/(shapes|materials)\//.test(p)) });
  });

const isMarked = (marked: readonly string[] | null, pointer: string) => marked?.includes(pointer) ?? false;
const marking = (path: string, marked: () => readonly string[] | null) => (pointers: string[]) => {
  const seen = pointers.filter(isSeen);
  if (seen.length > 0) attempt(() => post(path, { pointers: seen, isMarked: !seen.every((p) => isMarked(marked(), p)) }));
};

/** Hides things, or shows them where all are hidden; locks them, or unlocks them. */
export const toggleHidden = marking("view/hide", () => hidden.value);
export const toggleLocked = marking("view/lock", () => locked.value);
export const showAll = () => attempt(() => post("view/hide", { pointers: hidden.value ?? [], isMarked: false }));

/** Whether a thing is locked, or one that it is a part of. */
export const isLocked = (pointer: string) => (locked.value ?? []).some((p) => pointer === p || pointer.startsWith(`${p}/`));

export const rename = (pointer: string, name: string) => attempt(() => post("document/rename", { pointer, name }));

export interface Placement {
  pointer: string;
  gesture: string;
  translate?: Vec3;
  rotate?: { axis: Vec3; degrees: number; center: Vec3 };
  scale?: Vec3;
}

/** What can be copied, deleted or renamed: the members of lists, and what has a name under materials or textures. */
export const isThing = (pointer: string | null): pointer is string =>
  pointer !== null && /^\/(shapes|lights|materials|textures|objects)\/./.test(pointer);

/** What may be seen in the picture, moved and turned there. */
export const isSeen = (pointer: string | null): pointer is string => pointer !== null && /^\/(shapes|lights)\/./.test(pointer);

/** Runs a command on the selected things, if there are some that it can be run on, once it is known which they are. */
export async function withSelection(work: (pointers: string[]) => void): Promise<void> {
  await choosing;
  const pointers = (selected.value ?? []).filter(isThing);
  if (pointers.length > 0) work(pointers);
}

export const askForName = () => withSelection(() => isThing(selection.value) && (dialog.value = "rename"));
