/** The numbers of the pixel under the pointer. */

import { computed, effect, signal } from "@preact/signals";
import { get, Refusal } from "../api/client";
import { Latest } from "../api/latest";
import type { PixelReading } from "../api/types";
import type { Point } from "../math/projection";
import { map } from "../state/store";
import { cameraMoves, paintedFrames } from "./stage";

const pause = 200;
const hovered = signal<Point | null>(null);
const newest = signal<PixelReading | null>(null);

const asked = new Latest<Point>(
  async ({ x, y }) => {
    newest.value = await (await get<PixelReading[]>("view/pixels", { x, y, width: 1, height: 1 }))[0] ?? null;
    // Frames come one after the other: a number that changes faster cannot be read.
    await new Promise((resolve) => setTimeout(resolve, pause));
  },
  (error) => {
    newest.value = null;
    if (!(error instanceof Refusal) && !(error instanceof TypeError)) throw error;
  },
);

/** The numbers of the pixel under the pointer, as long as it is there. */
export const reading = computed(() => (newest.value?.x === hovered.value?.x && newest.value?.y === hovered.value?.y ? newest.value : null));

/** The pointer is over a pixel now, or over none. */
export function hover(pixel: Point | null): void {
  if (pixel?.x !== hovered.peek()?.x || pixel?.y !== hovered.peek()?.y) hovered.value = pixel;
}

effect(() => {
  void paintedFrames.value;
  void map.value;
  if (hovered.value && !cameraMoves.value) asked.push(hovered.value);
});
