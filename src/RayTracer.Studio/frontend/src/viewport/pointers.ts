/** Mouse, pen and touch on the picture. */

import { signal } from "@preact/signals";
import type { Point } from "../math/projection";
import { newGesture } from "../state/edits";
import { tool } from "../state/store";
import { endMove, move, moveInBurst } from "./camera";
import { clickPixel, renderRegion } from "./clicks";
import { openHere } from "./HereMenu";
import type { MoveKind } from "./moves";
import { hover } from "./reading";
import { picture, pixelAt, placement, shiftBy, toPicture, zoomBy } from "./stage";

/** The rectangle that is being drawn, in pixels of the picture. */
export const drawnRegion = signal<{ a: Point; b: Point } | null>(null);
export const spaceHeld = { value: false };

const clickDistance = 4;
const wheelStep = 1 / 1200;

type Action = { kind: "camera"; move: MoveKind; gesture: string } | { kind: "region"; start: Point } | { kind: "shift" };

function actionOf(e: PointerEvent): Action {
  const camera = (kind: MoveKind): Action => ({ kind: "camera", move: kind, gesture: newGesture() });
  if (e.button === 0 && (spaceHeld.value || e.altKey)) return { kind: "shift" };
  if (e.button === 1 || (e.button === 0 && e.shiftKey)) return camera("pan");
  if (e.button === 2) return camera("rotate");
  return tool.value === "region" ? { kind: "region", start: { x: 0, y: 0 } } : camera("orbit");
}

/** Listens on the stage; ends with the function that it returns. */
export function listenToPointers(stageElement: HTMLElement): () => void {
  const down = new Map<number, Point>();
  let action: Action | null = null;
  let start: Point = { x: 0, y: 0 };
  let around: [number, number] | undefined;
  let moved = false;
  let pinch = 0;

  const local = (e: MouseEvent): Point => {
    const box = stageElement.getBoundingClientRect();
    return { x: e.clientX - box.left, y: e.clientY - box.top };
  };
  const heights = (pixels: number) => pixels / (picture.value.height * placement.value.scale || 1);
  const spread = () => {
    const [a, b] = [...down.values()];
    return a && b ? Math.hypot(a.x - b.x, a.y - b.y) : 0;
  };
  const end = () => {
    if (action?.kind === "camera" && moved) endMove(action.move, action.gesture);
    action = null;
  };

  const onDown = (e: PointerEvent) => {
    if ((e.target as Element).closest("[data-handle]")) return;
    stageElement.focus({ preventScroll: true });
    stageElement.setPointerCapture(e.pointerId);
    down.set(e.pointerId, local(e));
    if (down.size === 2) {
      end();
      action = { kind: "camera", move: "pan", gesture: newGesture() };
      pinch = spread();
    } else if (down.size === 1) {
      start = local(e);
      moved = false;
      const pixel = pixelAt(start);
      around = pixel ? [pixel.x, pixel.y] : undefined;
      action = actionOf(e);
      if (action.kind === "region") action.start = toPicture(start);
    }
    if (e.button === 1) e.preventDefault();
  };

  const onMove = (e: PointerEvent) => {
    const before = down.get(e.pointerId);
    if (!before || !action) {
      hover(pixelAt(local(e)));
      return;
    }
    const now = local(e);
    const [dx, dy] = [now.x - before.x, now.y - before.y];
    moved ||= Math.hypot(now.x - start.x, now.y - start.y) > clickDistance || down.size > 1;
    down.set(e.pointerId, now);
    if (!moved) {
      down.set(e.pointerId, before);
      return;
    }
    if (action.kind === "shift") shiftBy(dx, dy);
    else if (action.kind === "region") drawnRegion.value = { a: action.start, b: toPicture(now) };
    else if (down.size === 2) {
      const wider = spread();
      move("pan", action.gesture, heights(dx / 2), heights(dy / 2));
      moveInBurst("dolly", 0, -heights(wider - pinch));
      pinch = wider;
    } else move(action.move, action.gesture, heights(dx), heights(dy), 0, around);
  };

  const onUp = (e: PointerEvent) => {
    if (!down.delete(e.pointerId) || !action) return;
    const region = drawnRegion.value;
    drawnRegion.value = null;
    if (region) renderRegion(region.a, region.b);
    else if (!moved && e.type === "pointerup" && (e.button === 0 || e.button === 2)) {
      const pixel = pixelAt(local(e));
      if (pixel && e.button === 2) openHere({ x: e.clientX, y: e.clientY }, pixel);
      else if (pixel) clickPixel(pixel, e.shiftKey);
    }
    end();
  };

  const onWheel = (e: WheelEvent) => {
    e.preventDefault();
    const turns = e.deltaMode === 1 ? e.deltaY * 30 : e.deltaY;
    if (e.ctrlKey || e.metaKey) zoomBy(2 ** (-turns / 240), local(e));
    else moveInBurst(e.altKey ? "zoom" : "dolly", 0, turns * wheelStep);
  };
  const onLeave = () => hover(null);
  const noMenu = (e: Event) => e.preventDefault();

  stageElement.addEventListener("pointerdown", onDown);
  stageElement.addEventListener("pointermove", onMove);
  stageElement.addEventListener("pointerup", onUp);
  stageElement.addEventListener("pointercancel", onUp);
  stageElement.addEventListener("pointerleave", onLeave);
  stageElement.addEventListener("wheel", onWheel, { passive: false });
  stageElement.addEventListener("contextmenu", noMenu);
  return () => {
    stageElement.removeEventListener("pointerdown", onDown);
    stageElement.removeEventListener("pointermove", onMove);
    stageElement.removeEventListener("pointerup", onUp);
    stageElement.removeEventListener("pointercancel", onUp);
    stageElement.removeEventListener("pointerleave", onLeave);
    stageElement.removeEventListener("wheel", onWheel);
    stageElement.removeEventListener("contextmenu", noMenu);
  };
}
