/** The keys of the animation: what there is, which are chosen, and what is done with them. */

import { computed, effect, signal } from "@preact/signals";
import { get, post } from "../api/client";
import { Latest } from "../api/latest";
import type { KeyChoice, TimelineRow, TimelineRows } from "../api/types";
import { attempt, complain } from "../state/messages";
import { bottomOpen, bottomTab, narrowWindow } from "../state/settings";
import { connection, documentState, revision, time } from "../state/store";

export const rows = signal<TimelineRow[]>([]);

/** A key is known by its list and its frame, which an edit of others does not change. */
export const nameOfKey = (list: string, frame: number) => `${list}@${frame.toFixed(3)}`;
export const chosen = signal<ReadonlySet<string>>(new Set());

/** The chosen keys, by the lists that they are in. */
export function choiceOf(all: readonly TimelineRow[], names: ReadonlySet<string>): KeyChoice[] {
  const numbers = (row: TimelineRow) => row.items.flatMap((key, i) => (names.has(nameOfKey(row.keys, key.frame)) ? [i] : []));
  return all.map((row) => ({ keys: row.keys, numbers: numbers(row) })).filter((c) => c.numbers.length > 0);
}

export const choice = computed(() => choiceOf(rows.value, chosen.value));

const asking = new Latest<number>(async () => (rows.value = (await get<TimelineRows>("timeline")).rows), complain);

// An arrow key that is held comes more quickly than answers: each edit begins with the keys that the one before has made.
let editing: Promise<unknown> = Promise.resolve();
const inTurn = (work: () => Promise<void>) => attempt(() => (editing = editing.then(work, work)));

const framesOf = () => choice.value.flatMap((c) => c.numbers.map((i) => rows.value.find((r) => r.keys === c.keys)!.items[i]!.frame));

/** Chooses what an edit has made of the keys, unless others were chosen while it was on its way. */
async function edit(request: Promise<{ revision: number }>, made: ReadonlySet<string>): Promise<void> {
  const before = chosen.value;
  asking.push((await request).revision);
  await asking.settled();
  if (chosen.value === before) chosen.value = made;
}

/** Moves the chosen keys, or puts copies of them elsewhere; what was moved stays chosen. */
export const moveKeys = (frames: number, copies: boolean, gesture?: string) =>
  inTurn(async () => {
    const keys = choice.value;
    const by = Math.max(frames, -Math.min(...framesOf()));
    if (keys.length === 0 || by === 0) return;
    const moved = new Set(keys.flatMap((c) => c.numbers.map((i) => nameOfKey(c.keys, rows.value.find((r) => r.keys === c.keys)!.items[i]!.frame + by))));
    await edit(post("timeline/move", { keys, frames: by, copies, gesture }), moved);
  });

export const removeKeys = () =>
  inTurn(async () => {
    if (choice.value.length > 0) await edit(post("timeline/remove", { keys: choice.value }), new Set());
  });

export const easeKeys = (ease: string) => attempt(() => post("timeline/ease", { keys: choice.value, ease }));

/** Copies of the chosen keys, the first of them at the frame that is shown. */
export const copyToPlayhead = () => moveKeys((time.value?.frame ?? 0) - Math.min(...framesOf()), true);

/** Asks for the keys whenever the text changes, and shows the timeline of a scene that is animated when it is opened. */
export function followKeys(): void {
  effect(() => {
    if (connection.value === "open" && revision.value >= 0) asking.push(revision.value);
  });

  const place = computed(() => documentState.value?.path ?? documentState.value?.name);
  const isAnimated = computed(() => (time.value?.frames ?? 0) > 0);
  let offered: string | undefined;
  let before = "source";
  effect(() => {
    if (place.value === offered) return;
    if (isAnimated.value) {
      offered = place.value;
      if (bottomTab.peek() !== "timeline") before = bottomTab.peek();
      bottomTab.value = "timeline";
      if (!narrowWindow.matches) bottomOpen.value = true;
    } else if (offered !== undefined && bottomTab.peek() === "timeline") {
      offered = undefined;
      bottomTab.value = before;
    }
  });
}
