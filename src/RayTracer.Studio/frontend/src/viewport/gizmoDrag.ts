/** Dragging a handle: each movement of the pointer becomes a change since the last one. */

import type { GizmoAnswer, Vec3 } from "../api/types";
import { alongAxis, angleBetween, onPlane } from "../math/gizmo";
import { project, rayThrough, type Point } from "../math/projection";
import { axes, scale, subtract } from "../math/vec3";
import { newGesture, type Placement } from "../state/edits";
import { toPicture } from "./stage";

export type GizmoKind = "move" | "rotate" | "scale";
export type Change = Omit<Placement, "pointer" | "gesture">;

/** The change between two points of the picture; null where it cannot be told (the axis points at the eye, say). */
export function changeBetween(kind: GizmoKind, answer: GizmoAnswer, axis: number | null, from: Point, to: Point): Change | null {
  const { camera, center } = answer;
  const [before, now] = [rayThrough(camera, from), rayThrough(camera, to)];
  if (axis === null) {
    if (kind === "scale") {
      const middle = project(camera, center);
      if (!middle) return null;
      const away = (p: Point) => Math.max(8, 60 + (p.x - middle.x) - (p.y - middle.y));
      const factor = away(to) / away(from);
      return { scale: [factor, factor, factor] };
    }
    const a = onPlane(before, center, camera.forward);
    const b = onPlane(now, center, camera.forward);
    return a && b && { translate: subtract(b, a) };
  }
  const direction = axes[axis]!;
  if (kind === "rotate") {
    const a = onPlane(before, center, direction);
    const b = onPlane(now, center, direction);
    return a && b && { rotate: { axis: direction, degrees: angleBetween(center, direction, a, b), center } };
  }
  const a = alongAxis(before, center, direction);
  const b = alongAxis(now, center, direction);
  if (a === null || b === null) return null;
  if (kind === "move") return { translate: scale(direction, b - a) };
  if (a * b <= 0) return null;
  return { scale: direction.map((d) => (d ? b / a : 1)) as Vec3 };
}

export function drag(e: PointerEvent, kind: GizmoKind, answer: GizmoAnswer, axis: number | null, push: (change: Change, gesture: string) => void): void {
  const stage = (e.currentTarget as Element).closest<HTMLElement>(".stage")!;
  const box = stage.getBoundingClientRect();
  const at = (move: PointerEvent) => toPicture({ x: move.clientX - box.left, y: move.clientY - box.top });
  const gesture = newGesture();
  let before = at(e);
  let center = answer.center;

  const onMove = (move: PointerEvent) => {
    const now = at(move);
    const change = changeBetween(kind, { ...answer, center }, axis, before, now);
    if (!change) return;
    before = now;
    if (change.translate) center = [center[0] + change.translate[0], center[1] + change.translate[1], center[2] + change.translate[2]];
    push(change, gesture);
  };
  // On the window: the handle itself is drawn anew while it is dragged.
  const onUp = () => {
    removeEventListener("pointermove", onMove);
    removeEventListener("pointerup", onUp);
    removeEventListener("pointercancel", onUp);
  };
  addEventListener("pointermove", onMove);
  addEventListener("pointerup", onUp);
  addEventListener("pointercancel", onUp);
  e.preventDefault();
}
