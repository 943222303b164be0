/** A pinhole camera: world to picture and back. Pixels are counted from the upper left corner. */

import type { Vec3, CameraFrame } from "../api/types";
import { add, cross, dot, normalize, scale, subtract } from "./vec3";

export interface Point {
  x: number;
  y: number;
}

export interface Ray {
  origin: Vec3;
  direction: Vec3;
}

/** Distance in pixels between eye and picture. */
const focal = (camera: CameraFrame) => camera.height / 2 / Math.tan((camera.fieldOfView * Math.PI) / 360);

/** Where a point is seen; null behind the eye. */
export function project(camera: CameraFrame, point: Vec3): Point | null {
  const seen = subtract(point, camera.position);
  const depth = dot(seen, camera.forward);
  if (depth <= 1e-6) return null;
  const f = focal(camera) / depth;
  return { x: camera.width / 2 + f * dot(seen, camera.right), y: camera.height / 2 - f * dot(seen, camera.up) };
}

const nearDepth = 1e-3;

/** Where a line between two points is seen, cut off just before the eye; null where all of it is behind. */
export function projectLine(camera: CameraFrame, a: Vec3, b: Vec3): [Point, Point] | null {
  const depthA = dot(subtract(a, camera.position), camera.forward) - nearDepth;
  const depthB = dot(subtract(b, camera.position), camera.forward) - nearDepth;
  if (depthA <= 0 && depthB <= 0) return null;
  const cut = add(a, scale(subtract(b, a), depthA / (depthA - depthB)));
  const start = project(camera, depthA > 0 ? a : cut);
  const end = project(camera, depthB > 0 ? b : cut);
  return start && end ? [start, end] : null;
}

/** The ray from the eye through a point of the picture. */
export function rayThrough(camera: CameraFrame, point: Point): Ray {
  const f = focal(camera);
  const sideways = add(
    scale(camera.right, (point.x - camera.width / 2) / f),
    scale(camera.up, (camera.height / 2 - point.y) / f),
  );
  return { origin: camera.position, direction: normalize(add(camera.forward, sideways)) };
}

/** The camera that stands around `target` at the angles (radians) and distance, with y up. */
export function orbitCamera(target: Vec3, yaw: number, pitch: number, distance: number, width: number, height: number): CameraFrame {
  const back: Vec3 = [Math.sin(yaw) * Math.cos(pitch), Math.sin(pitch), Math.cos(yaw) * Math.cos(pitch)];
  const forward = scale(back, -1);
  const right: Vec3 = [Math.cos(yaw), 0, -Math.sin(yaw)];
  return { position: add(target, scale(back, distance)), forward, right, up: cross(right, forward), fieldOfView: 40, width, height, lookAt: target };
}
