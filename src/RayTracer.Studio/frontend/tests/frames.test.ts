import { describe, expect, test } from "vitest";
import { headerSize, readHeader } from "../src/viewport/frame";
import { Painter } from "../src/viewport/painter";
import { place } from "../src/viewport/stage";

function frame(width: number, height: number, change: (view: DataView) => void = () => undefined): ArrayBuffer {
  const bytes = new ArrayBuffer(headerSize + 4 * width * height);
  const view = new DataView(bytes);
  [0x31465452, 7, width, height, 600, 400, 3, 12].forEach((value, i) => view.setUint32(4 * i, value, true));
  change(view);
  return bytes;
}

describe("a frame", () => {
  test("says what it is in its header", () => {
    expect(readHeader(frame(3, 2))).toEqual({ version: 7, width: 3, height: 2, pictureWidth: 600, pictureHeight: 400, isPreview: true, isLast: true, samples: 12, document: 0 });
  });

  test("is refused where it is none, or cut short", () => {
    expect(() => readHeader(new ArrayBuffer(8))).toThrow();
    expect(() => readHeader(frame(3, 2, (v) => v.setUint32(0, 1, true)))).toThrow();
    expect(() => readHeader(frame(3, 2).slice(0, 40))).toThrow();
  });
});

describe("the painter", () => {
  test("paints once in a frame of the screen, the newest picture, and then waits for the next", () => {
    const scheduled: (() => void)[] = [];
    const painted: number[] = [];
    const painter = new Painter<number>((paint) => scheduled.push(paint), (picture) => painted.push(picture));
    painter.push(1);
    painter.push(2);
    painter.push(3);
    expect(scheduled).toHaveLength(1);
    scheduled.shift()!();
    expect(painted).toEqual([3]);
    painter.push(4);
    expect(scheduled).toHaveLength(1);
    scheduled.shift()!();
    expect(painted).toEqual([3, 4]);
  });
});

describe("the picture's place on the stage", () => {
  const picture = { width: 400, height: 200 };
  const stage = { width: 424, height: 624 };

  test("is the middle, as large as fits, if nothing else is said", () => {
    expect(place(picture, stage, null, { x: 50, y: 50 })).toEqual({ scale: 1, left: 12, top: 212 });
  });

  test("has a size before there is a picture", () => {
    expect(place({ width: 0, height: 0 }, stage, null, { x: 0, y: 0 }).scale).toBe(1);
  });

  test("follows zoom and shift", () => {
    expect(place(picture, stage, 2, { x: 10, y: -20 })).toEqual({ scale: 2, left: -178, top: 92 });
  });
});
