/** An eye that is moved around a point by dragging, turning the wheel, or keys. */

import { signal, type Signal } from "@preact/signals";
import type { Vec3 } from "../api/types";

export interface Orbit {
  target: Vec3;
  yaw: number;
  pitch: number;
  distance: number;
}

export const newOrbit = (): Signal<Orbit | null> => signal(null);

const steepest = 1.5;

export function turned(orbit: Orbit, yaw: number, pitch: number): Orbit {
  return { ...orbit, yaw: orbit.yaw + yaw, pitch: Math.min(steepest, Math.max(-steepest, orbit.pitch + pitch)) };
}

export const nearer = (orbit: Orbit, factor: number): Orbit => ({ ...orbit, distance: Math.min(1e5, Math.max(1e-3, orbit.distance * factor)) });

/** An eye that sees all points, from the side that the scene's own camera looks from. */
export function around(points: Vec3[], from: Vec3): Orbit {
  const low: Vec3 = [Infinity, Infinity, Infinity];
  const high: Vec3 = [-Infinity, -Infinity, -Infinity];
  for (const p of points) for (const i of [0, 1, 2] as const) [low[i], high[i]] = [Math.min(low[i], p[i]), Math.max(high[i], p[i])];
  const target: Vec3 = points.length ? [(low[0] + high[0]) / 2, (low[1] + high[1]) / 2, (low[2] + high[2]) / 2] : [0, 0, 0];
  const size = points.length ? Math.hypot(high[0] - low[0], high[1] - low[1], high[2] - low[2]) : 5;
  const yaw = Math.atan2(from[0] - target[0], from[2] - target[2]) + 0.5;
  return { target, yaw, pitch: 0.35, distance: Math.max(0.1, size * 1.1) };
}
