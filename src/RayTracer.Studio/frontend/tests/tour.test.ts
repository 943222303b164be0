import { describe, expect, test } from "vitest";
import { besideFrame } from "../src/shell/beside";

const card = { width: 320, height: 200 };
const window = { width: 1280, height: 800 };

describe("the tour's card", () => {
  test.each([
    ["the picture", { left: 256, top: 64, width: 688, height: 448 }],
    ["the pane at the left", { left: 0, top: 32, width: 256, height: 744 }],
    ["the pane at the right", { left: 944, top: 32, width: 336, height: 744 }],
    ["the pane below", { left: 256, top: 512, width: 688, height: 264 }],
    ["the toolbar", { left: 0, top: 0, width: 1280, height: 32 }],
  ])("hides nothing of %s", (_, frame) => {
    const { left, top } = besideFrame(frame, card, window);
    const isApart = left >= frame.left + frame.width || left + card.width <= frame.left || top >= frame.top + frame.height || top + card.height <= frame.top;
    expect(isApart).toBe(true);
    expect(left >= 0 && top >= 0 && left + card.width <= window.width && top + card.height <= window.height).toBe(true);
  });

  test("stands in the window where what it explains fills that", () => {
    expect(besideFrame({ left: 0, top: 64, width: 900, height: 612 }, card, { width: 900, height: 700 })).toEqual({ left: 568, top: 464 });
  });
});
