import { expect, test } from "vitest";
import type { OutlineNode } from "../src/api/types";
import { extensionOf, folderOf, joinPath, nameOf, relativeTo, withExtension } from "../src/files/paths";
import { theoryLine } from "../src/inside/theory";
import { filterNodes, findNode } from "../src/outliner/find";
import { histogramOf } from "../src/viewport/histogram";
import { outlineOf } from "../src/viewport/mask";

test("the outline of a thing goes around it and not over it", () => {
  // A pixel in the middle of 5 × 5.
  const outline = outlineOf({ width: 5, height: 5, runs: [12, 1] }, 1);
  expect([...outline].map((v, i) => (v ? i : -1)).filter((i) => i >= 0)).toEqual([6, 7, 8, 11, 13, 16, 17, 18]);
});

test("the outline does not run over from one side of the picture to the other", () => {
  const outline = outlineOf({ width: 4, height: 3, runs: [7, 1] }, 1);
  expect(outline[8]).toBe(0);
  expect(outline[4]).toBe(0);
  expect(outline[6]).toBe(1);
});

test("a run may go over several rows", () => {
  expect([...outlineOf({ width: 2, height: 3, runs: [0, 4] }, 1)]).toEqual([0, 0, 0, 0, 1, 1]);
});

test("the theory's line has slope −1/2 and goes through the middle of the points", () => {
  const line = theoryLine([{ samples: 1, error: 0.2 }, { samples: 4, error: 0.1 }, { samples: 16, error: 0.05 }]);
  expect(line.map((v) => Number(v.toFixed(9)))).toEqual([0.2, 0.1, 0.05]);
});

test("paths of either system are taken apart and put together", () => {
  expect([folderOf("/a/b.json"), nameOf("/a/b.json"), extensionOf("/a/b.JSON")]).toEqual(["/a", "b.json", "json"]);
  expect([folderOf("C:\\a\\b.json"), nameOf("C:\\a\\b.json")]).toEqual(["C:\\a", "b.json"]);
  expect(joinPath("/", "a")).toBe("/a");
  expect(joinPath("C:\\a", "b")).toBe("C:\\a\\b");
  expect(withExtension("/a/b.json", "png")).toBe("/a/b.png");
  expect(withExtension("noise", "json")).toBe("noise.json");
});

test("files are named from the scene's folder, if they lie near it", () => {
  expect(relativeTo("/home/a/scenes/x.json", "/home/a/scenes/wood.png")).toBe("wood.png");
  expect(relativeTo("/home/a/scenes/x.json", "/home/a/pictures/wood.png")).toBe("../pictures/wood.png");
  expect(relativeTo("/home/a/x.json", "/mnt/wood.png")).toBe("/mnt/wood.png");
  expect(relativeTo(null, "/mnt/wood.png")).toBe("/mnt/wood.png");
  expect(relativeTo("C:\\a\\x.json", "C:\\a\\b\\wood.png")).toBe("b/wood.png");
});

test("the outliner finds things by name or type, with what they stand in", () => {
  const node = (name: string, children: OutlineNode[] = []): OutlineNode => ({ pointer: `/${name}`, name, type: "sphere", summary: "", isLight: false, color: null, children });
  const tree = [node("table", [node("leg"), node("top")]), node("ball")];
  expect(filterNodes(tree, "LEG")).toMatchObject([{ name: "table", children: [{ name: "leg" }] }]);
  expect(filterNodes(tree, "sphere")).toHaveLength(2);
  const none = node("none");
  const outline = { revision: 1, camera: none, render: none, background: none, environment: none, ambient: none, shapes: tree, lights: [], materials: [], textures: [], objects: [], idle: {} };
  expect(findNode(outline, "/top")?.name).toBe("top");
  expect(findNode(outline, "/nowhere")).toBeNull();
});

test("a histogram counts each channel, what is black and what is at its brightest", () => {
  const { channels, black, white } = histogramOf(new Uint8ClampedArray([0, 0, 0, 255, 255, 10, 7, 255, 4, 0, 0, 255, 8, 8, 8, 255]));
  expect([black, white]).toEqual([0.25, 0.25]);
  expect(channels.map((c) => c.reduce((a, b) => a + b))).toEqual([4, 4, 4]);
  expect(channels[0]!.slice(0, 3)).toEqual([1, 1, 1]);
  expect(channels[0]![63]).toBe(1);
  expect(channels[2]!.slice(0, 3)).toEqual([2, 1, 1]);
});
