import { beforeAll, expect, test } from "vitest";
import type { InspectedPath } from "../src/api/types";
import { orbitCamera, project } from "../src/math/projection";
import type { Vec3 } from "../src/api/types";
import { pretendBrowser } from "./browser";

let drawing: typeof import("../src/inside/drawScene");

beforeAll(async () => {
  pretendBrowser();
  drawing = await import("../src/inside/drawScene");
});

const camera = orbitCamera([0, 0, 0], 0, 0, 10, 400, 300);
const vertex = (position: Vec3, lights: Vec3[] = []) => ({ position, lights: lights.map((point) => ({ point, outcome: "arrives" })) });
const path = (sample: number, ...vertices: object[]) => ({ sample, radiance: [1, 1, 1], vertices, ways: [] }) as unknown as InspectedPath;
const samples = [path(0, vertex([3, 2, 0]), vertex([0, 0, 0], [[1, 1, 0]]), vertex([-1, 0, 0])), path(1, vertex([3, 2, 0]), vertex([0, 0, 0]), vertex([0, -1, 0]))];
const under = (place: Vec3, open = -1) => drawing.marksAt(camera, samples, 0, open, 100, project(camera, place)!);

test("what is pointed at in the drawing is a vertex of the chosen path, a light that it asks, or another path", () => {
  expect(under([-1, 0, 0])).toMatchObject({ vertex: 2, light: -1, sample: -1 });
  expect(under([0, 0, 0])).toMatchObject({ vertex: 1, sample: -1 });
  expect(under([1, 1, 0], 1)).toMatchObject({ vertex: -1, light: 0, sample: -1 });
  expect(under([1, 1, 0])).toEqual(drawing.noMarks);
  expect(under([0, -1, 0])).toMatchObject({ vertex: -1, light: -1, sample: 1 });
});
