/** What dragging a handle means in the world. */

import type { Vec3 } from "../api/types";
import type { Ray } from "./projection";
import { add, cross, dot, normalize, scale, subtract } from "./vec3";

/** The place along an axis through `center` that is nearest to a ray; null where the axis points at the eye. */
export function alongAxis(ray: Ray, center: Vec3, axis: Vec3): number | null {
  const between = subtract(center, ray.origin);
  const cosine = dot(axis, ray.direction);
  const determinant = 1 - cosine * cosine;
  if (determinant < 1e-4) return null;
  return (cosine * dot(between, ray.direction) - dot(between, axis)) / determinant;
}

/** Where a ray meets the plane through `center` with this normal; null where it runs beside it or away. */
export function onPlane(ray: Ray, center: Vec3, normal: Vec3): Vec3 | null {
  const slope = dot(ray.direction, normal);
  if (Math.abs(slope) < 1e-3) return null;
  const distance = dot(subtract(center, ray.origin), normal) / slope;
  return distance > 0 ? add(ray.origin, scale(ray.direction, distance)) : null;
}

/** The angle in degrees, counter-clockwise about the axis, from one point to another. */
export function angleBetween(center: Vec3, axis: Vec3, from: Vec3, to: Vec3): number {
  const a = subtract(from, center);
  const b = subtract(to, center);
  return (Math.atan2(dot(axis, cross(a, b)), dot(a, b)) * 180) / Math.PI;
}

/** Points of a circle about an axis. */
export function circle(center: Vec3, axis: Vec3, radius: number, count = 48): Vec3[] {
  const u = normalize(cross(axis, Math.abs(axis[1]) < 0.9 ? [0, 1, 0] : [1, 0, 0]));
  const v = cross(axis, u);
  return Array.from({ length: count + 1 }, (_, i) => {
    const angle = (i / count) * 2 * Math.PI;
    return add(center, add(scale(u, radius * Math.cos(angle)), scale(v, radius * Math.sin(angle))));
  });
}
