/** What moving the pointer from one pixel to another, with a handle held, changes in the world. */

import type { GizmoAnswer, Vec3 } from "../api/types";
import { alongAxis, angleBetween, onPlane } from "./gizmo";
import { project, rayThrough, type Point } from "./projection";
import { axes, scale, subtract } from "./vec3";

export type GizmoKind = "move" | "rotate" | "scale";
export interface Change {
  translate?: Vec3;
  rotate?: { axis: Vec3; degrees: number; center: Vec3 };
  scale?: Vec3;
}

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
