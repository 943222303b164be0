import { describe, expect, test } from "vitest";
import type { Vec3, ViewCamera } from "../src/api/types";
import { alongAxis, angleBetween, circle, onPlane } from "../src/math/gizmo";
import { orbitCamera, project, projectLine, rayThrough, unitsPerPixel } from "../src/math/projection";
import { add, cross, dot, length, scale, subtract } from "../src/math/vec3";
import { changeBetween } from "../src/math/gizmoChange";

const camera: ViewCamera = { position: [0, 0, 5], right: [1, 0, 0], up: [0, 1, 0], forward: [0, 0, -1], fieldOfView: 90, width: 200, height: 100 };

describe("a camera", () => {
  test("sees what is straight ahead in the middle, and the edge at half its angle", () => {
    expect(project(camera, [0, 0, 0])).toEqual({ x: 100, y: 50 });
    const top = project(camera, [0, 5, 0])!;
    expect(top.x).toBeCloseTo(100);
    expect(top.y).toBeCloseTo(0);
    expect(project(camera, [0, 0, 6])).toBeNull();
  });

  test("sends rays through where it sees points", () => {
    for (const point of [[1, 2, -3], [-0.5, 0.1, 2], [3, -1, 0]] as Vec3[]) {
      const { origin, direction } = rayThrough(camera, project(camera, point)!);
      expect(length(cross(subtract(point, origin), direction))).toBeCloseTo(0);
    }
  });

  test("cuts lines off that go behind the eye", () => {
    const line = projectLine(camera, [0, -1, 0], [0, -1, 20])!;
    expect(line[0].y).toBeCloseTo(60);
    expect(line[1].y).toBeGreaterThan(1000);
    expect(projectLine(camera, [0, 0, 6], [0, 0, 7])).toBeNull();
  });

  test("stands where it is told around a point, with axes at right angles", () => {
    const orbit = orbitCamera([1, 2, 3], 0.7, 0.4, 9, 300, 200);
    const middle = project(orbit, [1, 2, 3])!;
    expect(middle.x).toBeCloseTo(150);
    expect(middle.y).toBeCloseTo(100);
    for (const [a, b] of [[orbit.right, orbit.up], [orbit.up, orbit.forward], [orbit.forward, orbit.right]] as const) expect(dot(a, b)).toBeCloseTo(0);
    expect(cross(orbit.right, orbit.up)).toEqual(scale(orbit.forward, -1).map((v) => expect.closeTo(v)));
    expect(orbit.up[1]).toBeGreaterThan(0);
  });
});

describe("a handle", () => {
  const answer = { center: [0, 0, 0] as Vec3, radius: 1, bounds: [[-1, -1, -1], [1, 1, 1]] as [Vec3, Vec3], camera };

  test("along an axis follows the pointer", () => {
    const to = project(camera, [1.5, 0, 0])!;
    expect(alongAxis(rayThrough(camera, to), [0, 0, 0], [1, 0, 0])).toBeCloseTo(1.5);
    expect(alongAxis(rayThrough(camera, { x: 100, y: 50 }), [0, 0, 0], [0, 0, 1])).toBeNull();
    const change = changeBetween("move", answer, 0, project(camera, [0.5, 0, 0])!, to);
    expect(change?.translate?.[0]).toBeCloseTo(1);
    expect(change?.translate?.slice(1)).toEqual([0, 0]);
  });

  test("in the middle moves across the picture", () => {
    const change = changeBetween("move", answer, null, { x: 100, y: 50 }, project(camera, [1, 2, 0])!);
    expect(change?.translate).toEqual([expect.closeTo(1), expect.closeTo(2), expect.closeTo(0)]);
  });

  test("of a ring turns by the angle between the two points, counter-clockwise", () => {
    const change = changeBetween("rotate", answer, 2, project(camera, [1, 0, 0])!, project(camera, [0, 1, 0])!);
    expect(change?.rotate?.degrees).toBeCloseTo(90);
    expect(angleBetween([0, 0, 0], [0, 1, 0], [0, 0, 1], [1, 0, 0])).toBeCloseTo(90);
  });

  test("of a scale changes by the ratio of the distances", () => {
    const change = changeBetween("scale", answer, 1, project(camera, [0, 0.5, 0])!, project(camera, [0, 1, 0])!);
    expect(change?.scale).toEqual([1, expect.closeTo(2), 1]);
  });

  test("is drawn as large as pixels say, and rings are round", () => {
    expect(unitsPerPixel(camera, [0, 0, 0])).toBeCloseTo(0.1);
    for (const p of circle([1, 1, 1], [0, 1, 0], 2)) {
      expect(length(subtract(p, [1, 1, 1]))).toBeCloseTo(2);
      expect(p[1]).toBeCloseTo(1);
    }
    expect(onPlane({ origin: [0, 0, 5], direction: [0, 0, 1] }, [0, 0, 0], [0, 0, 1])).toBeNull();
    expect(add([1, 2, 3], [1, 1, 1])).toEqual([2, 3, 4]);
  });
});
