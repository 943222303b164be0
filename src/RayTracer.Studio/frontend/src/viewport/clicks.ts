/** What a click in the picture does, by the chosen tool. */

import { get, post } from "../api/client";
import type { PickResult } from "../api/types";
import type { Point } from "../math/projection";
import { choose } from "../state/edits";
import { attempt } from "../state/messages";
import { bottomOpen, bottomTab, rightTab } from "../state/settings";
import { inspectedPixel, tool } from "../state/store";
import { picture } from "./stage";

export function clickPixel(pixel: Point, adds = false): void {
  const { x, y } = pixel;
  if (tool.value === "focus") attempt(() => post("view/focus", { x, y }));
  else if (tool.value === "inspect") inspect(pixel);
  else
    attempt(() =>
      choose(async () => {
        const { pointer } = await get<PickResult>("pick", { x, y });
        if (pointer) rightTab.value = "object";
        // Beside what is selected, a click on nothing is a slip.
        return pointer || !adds ? { pointer, adds } : null;
      }),
    );
}

export function inspect(pixel: Point): void {
  inspectedPixel.value = pixel;
  bottomOpen.value = true;
  bottomTab.value = "paths";
}

/** The whole pixels of the picture within a rectangle between two points; null where there are none. */
export function regionBetween(a: Point, b: Point, size: { width: number; height: number }): number[] | null {
  const left = Math.max(0, Math.floor(Math.min(a.x, b.x)));
  const top = Math.max(0, Math.floor(Math.min(a.y, b.y)));
  const right = Math.min(size.width, Math.ceil(Math.max(a.x, b.x)));
  const bottom = Math.min(size.height, Math.ceil(Math.max(a.y, b.y)));
  return right - left > 1 && bottom - top > 1 ? [left, top, right - left, bottom - top] : null;
}

export function renderRegion(a: Point, b: Point): void {
  const region = regionBetween(a, b, picture.value);
  if (!region) return;
  tool.value = "select";
  attempt(() => post("view/render", { region }));
}

export const clearRegion = () => attempt(() => post("view/render", { region: [] }));
