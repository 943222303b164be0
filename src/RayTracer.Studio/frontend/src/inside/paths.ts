import { effect, signal } from "@preact/signals";
import { get } from "../api/client";
import { Latest } from "../api/latest";
import type { InspectedPixel, PixelSummary, TreeWalk, WireframeView } from "../api/types";
import { complain } from "../state/messages";
import { inspectedPixel, revision } from "../state/store";

const perPage = 16;
export const firstSample = signal(0);
export const chosenSample = signal(0);

/** The chosen one of the sample's ways to the lights; -1 for none. */
export const chosenWay = signal(-1);

/** The vertex that is open, and the one under the pointer; -1 for none. */
export const openVertex = signal(-1);
export const pointedVertex = signal(-1);

/** The light that the open vertex asks, and the sample, that are pointed at in the lists or in the drawings; -1 for none. */
export const pointedLight = signal(-1);
export const pointedSample = signal(-1);

/** The samples that have the light of the bar that is pointed at or chosen; null for all. */
export const litSamples = signal<readonly number[] | null>(null);

/** Whether all samples' paths are drawn over the picture, or the chosen one's. */
export const drawsAll = signal(false);
export const paths = signal<InspectedPixel | null>(null);
export const summary = signal<PixelSummary | null>(null);

/** The tree of the textbook edition that a ray is followed through; "" for none. */
export const tree = signal("");

/** Its way through the tree, and how many nodes of it are shown. */
export const walk = signal<TreeWalk | null>(null);
export const step = signal(0);

/** The scene as lines, and its camera. */
export const wireframe = signal<WireframeView | null>(null);

const asking = new Latest<{ x: number; y: number; first: number }>(async ({ x, y, first }) => {
  paths.value = await get<InspectedPixel>("paths", { x, y, first, count: perPage });
  chosenWay.value = -1;
  pointedSample.value = pointedVertex.value = pointedLight.value = -1;
  if (!paths.value.samples.some((s) => s.sample === chosenSample.value)) chosenSample.value = first;
}, complain);

const summing = new Latest<{ x: number; y: number }>(async ({ x, y }) => {
  summary.value = await get<PixelSummary>("paths/summary", { x, y });
}, complain);

const walking = new Latest<{ x: number; y: number; sample: number; ray: number; tree: string }>(async (ray) => {
  walk.value = await get<TreeWalk>("paths/tree", ray);
  step.value = 0;
}, (e) => {
  walk.value = null;
  complain(e);
});

let shownPixel: object | null = null;

/** Whether the paths follow the scene: else they are those of a picture that may be gone. */
export const isFollowing = signal(false);

/** Turns to a sample, on whatever page it is. */
export function showSample(sample: number): void {
  shownPixel = inspectedPixel.peek();
  firstSample.value = Math.floor(sample / perPage) * perPage;
  [chosenSample.value, chosenWay.value] = [sample, -1];
}

/** Asks for the paths of the inspected pixel whenever it, the page or the scene changes; ends with the function that it returns. */
export const followPaths = () => {
  if (inspectedPixel.peek() !== shownPixel) paths.value = null;
  isFollowing.value = true;
  const stopPaths = effect(() => {
    const pixel = inspectedPixel.value;
    if (!pixel) paths.value = null;
    if (pixel !== shownPixel) [shownPixel, firstSample.value, chosenSample.value, openVertex.value] = [pixel, 0, 0, -1];
    if (pixel && revision.value >= 0) asking.push({ ...pixel, first: firstSample.value });
  });
  const stopSummary = effect(() => {
    const pixel = inspectedPixel.value;
    litSamples.value = summary.value = null;
    if (pixel && revision.value >= 0) summing.push(pixel);
  });
  const stopWalk = effect(() => {
    const pixel = inspectedPixel.value;
    if (pixel && tree.value && revision.value >= 0) walking.push({ ...pixel, sample: chosenSample.value, ray: Math.max(1, openVertex.value), tree: tree.value });
    else walk.value = null;
  });
  return () => {
    isFollowing.value = false;
    stopPaths();
    stopSummary();
    stopWalk();
  };
};
