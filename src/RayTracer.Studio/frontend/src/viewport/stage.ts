/** Where the picture lies on the stage, the part of the window that it is shown in. */

import { computed, signal } from "@preact/signals";
import { documentState } from "../state/store";
import type { Point } from "../math/projection";

/** The picture's size, known from its newest frame. */
export const picture = signal({ width: 0, height: 0 });

/** The document that the newest frame shows; -1 before the first. */
export const paintedDocument = signal(-1);

/** Whether the picture on the stage is of the scene that is open, and not of the one before it. */
export const isOwnPicture = computed(() => documentState.value !== null && paintedDocument.value === documentState.value.document);

/** The stage's size in CSS pixels. */
export const stage = signal({ width: 1, height: 1 });

/** CSS pixels for each pixel of the picture; null: as large as fits. */
export const zoom = signal<number | null>(null);

/** How far the picture's middle is from the stage's, in CSS pixels. */
export const shift = signal<Point>({ x: 0, y: 0 });

export const cameraMoves = signal(false);

/** Counts the frames that were painted while the camera moves: what is drawn over the picture follows them. */
export const movingFrames = signal(0);

/** Counts all frames that were painted. */
export const paintedFrames = signal(0);

/** The colours of the newest one: red, green, blue and 255 of each of its pixels. */
export const paintedPixels = signal(new Uint8ClampedArray());

const margin = 12;
const largestZoom = 64;

export interface Placement {
  scale: number;
  left: number;
  top: number;
}

export function place(picture: { width: number; height: number }, stage: { width: number; height: number }, zoom: number | null, shift: Point): Placement {
  const fitting = Math.min((stage.width - 2 * margin) / picture.width, (stage.height - 2 * margin) / picture.height);
  // Before the first picture there is no size to fit.
  const scale = zoom ?? (Number.isFinite(fitting) ? Math.max(fitting, 0.01) : 1);
  const offset = zoom === null ? { x: 0, y: 0 } : shift;
  return {
    scale,
    left: Math.round((stage.width - picture.width * scale) / 2 + offset.x),
    top: Math.round((stage.height - picture.height * scale) / 2 + offset.y),
  };
}

export const placement = computed(() => place(picture.value, stage.value, zoom.value, shift.value));

/** The point of the picture under a point of the stage. */
export function toPicture(point: Point): Point {
  const { scale, left, top } = placement.value;
  return { x: (point.x - left) / scale, y: (point.y - top) / scale };
}

/** Where pixels of the picture are on the stage. */
export function pointsOnStage(pixels: readonly (readonly [number, number])[]): Point[] {
  const { scale, left, top } = placement.value;
  return pixels.map(([x, y]) => ({ x: left + x * scale, y: top + y * scale }));
}

/** The pixel under a point of the stage; null outside the picture. */
export function pixelAt(point: Point): Point | null {
  const { x, y } = toPicture(point);
  const pixel = { x: Math.floor(x), y: Math.floor(y) };
  const isInside = pixel.x >= 0 && pixel.y >= 0 && pixel.x < picture.value.width && pixel.y < picture.value.height;
  return isInside ? pixel : null;
}

/** The pixels that are on the stage, of which the first is at x and y. */
export function partOnStage(): { x: number; y: number; width: number; height: number } {
  const [from, to] = [toPicture({ x: 0, y: 0 }), toPicture({ x: stage.value.width, y: stage.value.height })];
  const [x, y] = [Math.max(0, Math.floor(from.x)), Math.max(0, Math.floor(from.y))];
  return { x, y, width: Math.min(picture.value.width, Math.ceil(to.x)) - x, height: Math.min(picture.value.height, Math.ceil(to.y)) - y };
}

/** Enlarges by a factor; the point of the picture under `around` stays where it is. */
export function zoomBy(factor: number, around: Point = { x: stage.value.width / 2, y: stage.value.height / 2 }): void {
  const before = placement.value;
  const scale = Math.min(Math.max(before.scale * factor, 0.05), largestZoom);
  const real = scale / before.scale;
  const middle = { x: before.left + (picture.value.width * before.scale) / 2, y: before.top + (picture.value.height * before.scale) / 2 };
  zoom.value = scale;
  shift.value = {
    x: around.x + (middle.x - around.x) * real - stage.value.width / 2,
    y: around.y + (middle.y - around.y) * real - stage.value.height / 2,
  };
}

export function fit(): void {
  zoom.value = null;
  shift.value = { x: 0, y: 0 };
}

/** So many CSS pixels for each pixel of the picture; what is in the middle stays there. */
export const zoomTo = (scale: number) => zoomBy(scale / placement.value.scale);

/** One pixel of the picture on one pixel of the screen. */
export const actualSize = () => zoomTo(1 / devicePixelRatio);

export const shiftBy = (dx: number, dy: number) => {
  if (zoom.value === null) zoom.value = placement.value.scale;
  shift.value = { x: shift.value.x + dx, y: shift.value.y + dy };
};
