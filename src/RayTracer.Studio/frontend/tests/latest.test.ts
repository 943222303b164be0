import { expect, test } from "vitest";
import { Latest } from "../src/api/latest";
import { mergeMoves, type Move } from "../src/viewport/moves";

test("while one request is under way, only the newest waits", async () => {
  const sent: number[] = [];
  let release: () => void = () => undefined;
  const latest = new Latest<number>((n) => new Promise<void>((resolve) => ((release = resolve), sent.push(n))), () => undefined);
  for (const n of [1, 2, 3, 4]) latest.push(n);
  expect(sent).toEqual([1]);
  release();
  await Promise.resolve();
  await Promise.resolve();
  expect(sent).toEqual([1, 4]);
  release();
  await latest.settled();
  expect(sent).toEqual([1, 4]);
});

test("a failed request is reported, and the next one is sent all the same", async () => {
  const failures: unknown[] = [];
  const latest = new Latest<number>((n) => (n === 1 ? Promise.reject(new Error("no")) : Promise.resolve()), (e) => failures.push(e));
  latest.push(1);
  latest.push(2);
  await latest.settled();
  expect(failures).toHaveLength(1);
});

test("moves of one gesture are added up, and no end of a gesture is lost", () => {
  const move = (gesture: string, dx: number, more: Partial<Move> = {}): Move => ({ kind: "orbit", dx, dy: 0, dz: 0, gesture, ...more });
  expect(mergeMoves([move("a", 1)], [move("a", 2)])).toEqual([move("a", 3)]);
  expect(mergeMoves([move("a", 1)], [move("a", 0, { end: true })])).toEqual([move("a", 1, { end: true })]);
  expect(mergeMoves([move("a", 1, { end: true })], [move("b", 2)])).toHaveLength(2);
  expect(mergeMoves([move("a", 1)], [move("a", 2, { kind: "pan" })])).toHaveLength(2);
});
