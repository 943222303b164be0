/** Dragging a handle: each movement of the pointer becomes a change since the last one. */

import type { GizmoAnswer } from "../api/types";
import { changeBetween, type Change, type GizmoKind } from "../math/gizmoChange";
import { add } from "../math/vec3";
import { newGesture } from "../state/edits";
import { toPicture } from "./stage";

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
    if (change.translate) center = add(center, change.translate);
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
