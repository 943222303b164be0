import { beforeAll, expect, test, vi } from "vitest";
import { animatedAt, atTime } from "../src/timeline/atTime";
import { pretendBrowser } from "./browser";

let keys: typeof import("../src/timeline/keys");
let paths: typeof import("../src/timeline/MotionPaths");
let ruler: typeof import("../src/timeline/Ruler");
let rowName: typeof import("../src/timeline/KeyRow");

beforeAll(async () => {
  pretendBrowser();
  [keys, paths, ruler, rowName] = await Promise.all([import("../src/timeline/keys"), import("../src/timeline/MotionPaths"), import("../src/timeline/Ruler"), import("../src/timeline/KeyRow")]);
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

const rowOf = (frames: number[]) => ({ keys: "/a/keys", label: "a", pointer: "/a", thing: "/a", isMotion: false, items: frames.map((frame) => ({ frame, ease: "linear", value: 1 })) });

/** A server that moves keys when it is allowed to answer. */
function pretendServer(frames: number[]) {
  keys.rows.value = [rowOf(frames)];
  let now = frames;
  let answer: () => void = () => undefined;
  vi.stubGlobal("fetch", (url: string, init: RequestInit) => {
    if (!url.includes("move")) return Promise.resolve(Response.json({ rows: [rowOf(now)] }));
    const { keys: [list], frames: by } = JSON.parse(init.body as string) as { keys: { numbers: number[] }[]; frames: number };
    return new Promise<Response>((resolve) => (answer = () => {
      now = now.map((f, i) => (list!.numbers.includes(i) ? f + by : f));
      resolve(Response.json({ revision: 1 }));
    }));
  });
  // All that follows the answer is done before the next task.
  return async () => {
    answer();
    await new Promise((resolve) => setTimeout(resolve));
  };
}

const nothingElse = () => new Promise((resolve) => setTimeout(resolve));

test("keys that are chosen while others are moved stay chosen", async () => {
  const move = async (meanwhile: () => void) => {
    const answered = pretendServer([0, 48]);
    keys.chosen.value = new Set([keys.nameOfKey("/a/keys", 48)]);
    keys.moveKeys(-24, false);
    await nothingElse();
    meanwhile();
    await answered();
    return [...keys.chosen.value];
  };
  expect(await move(() => undefined)).toEqual([keys.nameOfKey("/a/keys", 24)]);
  const other = keys.nameOfKey("/a/keys", 0);
  expect(await move(() => (keys.chosen.value = new Set([other])))).toEqual([other]);
  vi.unstubAllGlobals();
});

test("keys that are moved again before the answer has come move on, and stay chosen", async () => {
  const answered = pretendServer([0, 10]);
  keys.chosen.value = new Set([keys.nameOfKey("/a/keys", 10)]);
  keys.moveKeys(1, false);
  keys.moveKeys(1, false);
  await nothingElse();
  await answered();
  await answered();
  expect(keys.rows.value[0]!.items.map((k) => k.frame)).toEqual([0, 12]);
  expect([...keys.chosen.value]).toEqual([keys.nameOfKey("/a/keys", 12)]);
  vi.unstubAllGlobals();
});

test("the last step of a row's name stands by itself", () => {
  expect(rowName.partsOfLabel("shapes.ball.transform[0].translate")).toEqual(["shapes.ball.transform[0]", ".translate"]);
  expect(rowName.partsOfLabel("ball")).toEqual(["", "ball"]);
});
