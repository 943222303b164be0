import { effect, signal } from "@preact/signals";
import { get } from "../api/client";
import { Latest } from "../api/latest";
import type { InspectedPixel } from "../api/types";
import { complain } from "../state/messages";
import { inspectedPixel, revision } from "../state/store";

const perPage = 16;
export const firstSample = signal(0);
export const chosenSample = signal(0);

/** The chosen one of the sample's ways to the lights; -1 for none. */
export const chosenWay = signal(-1);
export const paths = signal<InspectedPixel | null>(null);

const asking = new Latest<{ x: number; y: number; first: number }>(async ({ x, y, first }) => {
  paths.value = await get<InspectedPixel>("paths", { x, y, first, count: perPage });
  chosenWay.value = -1;
  if (!paths.value.samples.some((s) => s.sample === chosenSample.value)) chosenSample.value = first;
}, complain);

let shownPixel: object | null = null;

/** Asks for the paths of the inspected pixel whenever it, the page or the scene changes; ends with the function that it returns. */
export const followPaths = () =>
  effect(() => {
    const pixel = inspectedPixel.value;
    if (pixel !== shownPixel) [shownPixel, firstSample.value, chosenSample.value] = [pixel, 0, 0];
    if (pixel && revision.value >= 0) asking.push({ ...pixel, first: firstSample.value });
  });
