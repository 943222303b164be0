import { beforeAll, expect, test, vi } from "vitest";
import { animatedAt, atTime } from "../src/timeline/atTime";
import { pretendBrowser } from "./browser";

let keys: typeof import("../src/timeline/keys");
let paths: typeof import("../src/timeline/MotionPaths");
let ruler: typeof import("../src/timeline/Ruler");

beforeAll(async () => {
  pretendBrowser();
  [keys, paths, ruler] = await Promise.all([import("../src/timeline/keys"), import("../src/timeline/MotionPaths"), import("../src/timeline/Ruler")]);
});

const animated = [
  { pointer: "/shapes/2/b/1", value: 1.6, hasKey: true },
  { pointer: "/camera/position", value: [1, 2, 3], hasKey: false },
  { pointer: "/camera/fieldOfView", value: null, hasKey: false },
];

test("animated values are shown as they are at the frame", () => {
  expect(atTime("/shapes/2/b", [0, 0.6, 1], animated)).toEqual([0, 1.6, 1]);
  expect(atTime("/camera/position", undefined, animated)).toEqual([1, 2, 3]);
  expect(atTime("/camera/fieldOfView", 34, animated)).toBe(34);
  expect(atTime("/shapes/2", { b: [0, 0, 0] }, animated)).toEqual({ b: [0, 0, 0] });
  expect(animatedAt("/shapes/2/b", animated).map((a) => a.pointer)).toEqual(["/shapes/2/b/1"]);
  expect(animatedAt("/shapes/2", animated)).toEqual([]);
});

test("chosen keys are found again by their frames", () => {
  const key = (frame: number) => ({ frame, ease: "linear", value: 1 });
  const rows = [
    { keys: "/animation/0/keys", label: "a", pointer: "/a", thing: "/a", isMotion: false, items: [key(0), key(12), key(24)] },
    { keys: "/animation/1/keys", label: "b", pointer: "/b", thing: "/b", isMotion: false, items: [key(12)] },
  ];
  const names = new Set([keys.nameOfKey("/animation/0/keys", 12), keys.nameOfKey("/animation/0/keys", 24)]);
  expect(keys.choiceOf(rows, names)).toEqual([{ keys: "/animation/0/keys", numbers: [1, 2] }]);
});

test("marks are a dozen, at round frames", () => {
  expect([4, 48, 250, 10_000].map(ruler.markStep)).toEqual([1, 5, 50, 1000]);
});

test("a way has gaps behind the eye", () => {
  expect(paths.pathOf([[0, 1], [2, 3], null, [4, 5]])).toBe("M0.0 1.0L2.0 3.0M4.0 5.0");
});

test("keys that are chosen while others are moved stay chosen", async () => {
  const row = { keys: "/a/keys", label: "a", pointer: "/a", thing: null, isMotion: false, items: [0, 48].map((frame) => ({ frame, ease: "linear", value: 1 })) };
  keys.rows.value = [row] as never;
  let answer: (response: Response) => void = () => undefined;
  vi.stubGlobal("fetch", () => new Promise<Response>((resolve) => (answer = resolve)));
  const move = async (meanwhile: () => void) => {
    keys.chosen.value = new Set([keys.nameOfKey("/a/keys", 48)]);
    keys.moveKeys(-24, false);
    meanwhile();
    answer(new Response("{}"));
    // All that follows the answer is done before the next task.
    await new Promise((resolve) => setTimeout(resolve));
    return [...keys.chosen.value];
  };
  expect(await move(() => undefined)).toEqual([keys.nameOfKey("/a/keys", 24)]);
  const other = keys.nameOfKey("/a/keys", 0);
  expect(await move(() => (keys.chosen.value = new Set([other])))).toEqual([other]);
  vi.unstubAllGlobals();
});
