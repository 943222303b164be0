/** Dragging a handle: the server works out what the way of the pointer means in the world. */

import { newGesture } from "../state/edits";
import { toPicture } from "./stage";

/** A point of the picture, in pixels. */
type Pixel = [number, number];

export function drag(e: PointerEvent, push: (from: Pixel, to: Pixel, gesture: string) => void): void {
  const stage = (e.currentTarget as Element).closest<HTMLElement>(".stage")!;
  const box = stage.getBoundingClientRect();
  const at = (move: PointerEvent): Pixel => {
    const { x, y } = toPicture({ x: move.clientX - box.left, y: move.clientY - box.top });
    return [x, y];
  };
  const gesture = newGesture();
  const from = at(e);
  const onMove = (move: PointerEvent) => push(from, at(move), gesture);

  // On the window: the handle itself is replaced while it is dragged.
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
