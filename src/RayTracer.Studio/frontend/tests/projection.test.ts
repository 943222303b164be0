import { describe, expect, test } from "vitest";
import type { Vec3, CameraFrame } from "../src/api/types";
import { orbitCamera, project, projectLine, rayThrough } from "../src/math/projection";
import { cross, dot, length, scale, subtract } from "../src/math/vec3";

const camera: CameraFrame = { position: [0, 0, 5], right: [1, 0, 0], up: [0, 1, 0], forward: [0, 0, -1], fieldOfView: 90, width: 200, height: 100, lookAt: [0, 0, 0] };

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

  test("stands where it is placed around a point, with axes at right angles", () => {
    const orbit = orbitCamera([1, 2, 3], 0.7, 0.4, 9, 300, 200);
    const middle = project(orbit, [1, 2, 3])!;
    expect(middle.x).toBeCloseTo(150);
    expect(middle.y).toBeCloseTo(100);
    for (const [a, b] of [[orbit.right, orbit.up], [orbit.up, orbit.forward], [orbit.forward, orbit.right]] as const) expect(dot(a, b)).toBeCloseTo(0);
    expect(cross(orbit.right, orbit.up)).toEqual(scale(orbit.forward, -1).map((v) => expect.closeTo(v)));
    expect(orbit.up[1]).toBeGreaterThan(0);
  });
});
