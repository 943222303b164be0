import { expect, test, vi } from "vitest";
import { Latest } from "../src/api/latest";
import { Pace } from "../src/viewport/pace";

function paced(milliseconds: number): { pace: Pace; sent: number[]; latest: Latest<number> } {
  const pace = new Pace();
  for (let i = 0; i < 50; i++) pace.painted(i * milliseconds);
  const sent: number[] = [];
  const send = (n: number) => (sent.push(n), Promise.resolve());
  return { pace, sent, latest: new Latest<number>(send, () => undefined, (a, b) => a + b, () => pace.rest()) };
}

test("moves are sent little more often than pictures come, and none is lost", async () => {
  vi.useFakeTimers();
  const { sent, latest } = paced(40);
  for (let i = 0; i < 200; i++) {
    latest.push(1);
    await vi.advanceTimersByTimeAsync(4);
  }
  await vi.advanceTimersByTimeAsync(100);
  expect(sent.reduce((a, b) => a + b, 0)).toBe(200);
  expect(sent.length).toBeGreaterThan(20);
  expect(sent.length).toBeLessThan(30);
  vi.useRealTimers();
});

test("the first move is sent at once, and the last one does not wait", async () => {
  vi.useFakeTimers();
  const { pace, sent, latest } = paced(40);
  latest.push(1);
  expect(sent).toEqual([1]);
  latest.push(2);
  await vi.advanceTimersByTimeAsync(1);
  expect(sent).toEqual([1]);
  pace.hurry();
  await vi.advanceTimersByTimeAsync(0);
  expect(sent).toEqual([1, 2]);
  vi.useRealTimers();
});

test("the last one does not wait for the rest after a request that is under way", async () => {
  vi.useFakeTimers();
  const { pace, sent, latest } = paced(40);
  latest.push(1);
  latest.push(2);
  pace.hurry();
  await vi.advanceTimersByTimeAsync(0);
  expect(sent).toEqual([1, 2]);
  vi.useRealTimers();
});

test("slow pictures do not make moves late", async () => {
  vi.useFakeTimers();
  const { sent, latest } = paced(1000);
  latest.push(1);
  latest.push(2);
  await vi.advanceTimersByTimeAsync(51);
  expect(sent).toEqual([1, 2]);
  vi.useRealTimers();
});
