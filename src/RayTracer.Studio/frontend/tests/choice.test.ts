import { beforeAll, expect, test, vi } from "vitest";
import type { StudioState } from "../src/api/types";
import { pretendBrowser } from "./browser";

let edits: typeof import("../src/state/edits");
let store: typeof import("../src/state/store");

beforeAll(async () => {
  pretendBrowser();
  edits = await import("../src/state/edits");
  store = await import("../src/state/store");
});

const state = (version: number, selected: string[]) => ({ version, selected, selection: selected.at(-1) ?? null }) as unknown as StudioState;
const turns = async () => {
  for (let i = 0; i < 20; i++) await Promise.resolve();
};

test("what is done to the selection waits until the page knows what was chosen last", async () => {
  store.connection.value = "open";
  store.studio.value = state(4, ["/shapes/0"]);
  let answer = (_: Response) => undefined as void;
  vi.stubGlobal("fetch", () => new Promise<Response>((resolve) => (answer = resolve)));
  const done: string[][] = [];
  edits.select("/shapes/1");
  void edits.withSelection((pointers) => done.push(pointers));
  await turns();
  expect(done).toEqual([]);

  answer(new Response(JSON.stringify({ version: 6 })));
  await turns();
  store.studio.value = state(5, ["/shapes/0"]);
  await turns();
  expect(done).toEqual([]);
  store.studio.value = state(6, ["/shapes/1"]);
  await vi.waitFor(() => expect(done).toEqual([["/shapes/1"]]));
});

test("nothing waits for a server that is gone", async () => {
  store.connection.value = "open";
  store.studio.value = state(7, ["/shapes/2"]);
  vi.stubGlobal("fetch", async () => new Response(JSON.stringify({ version: 9 })));
  const done: string[][] = [];
  edits.select("/shapes/3");
  void edits.withSelection((pointers) => done.push(pointers));
  store.connection.value = "lost";
  await vi.waitFor(() => expect(done).toEqual([["/shapes/2"]]));
});

test("the pixel that is looked at belongs to its scene", () => {
  const open = (document: number, revision: number) => ({ ...state(20 + revision, []), document: { document, revision } }) as unknown as StudioState;
  store.studio.value = null;
  store.take(open(1, 1));
  store.inspectedPixel.value = { x: 3, y: 4 };
  store.take(open(1, 2));
  expect(store.inspectedPixel.value).toEqual({ x: 3, y: 4 });
  store.take(open(2, 3));
  expect(store.inspectedPixel.value).toBeNull();
});
