import { expect, test } from "vitest";
import { asColor, fromHex, toHex } from "../src/json/color";

test("every 8-bit colour comes back from its linear numbers", () => {
  for (let i = 0; i < 256; i++) {
    const hex = `#${i.toString(16).padStart(2, "0").repeat(3)}`;
    expect(toHex(fromHex(hex))).toBe(hex);
  }
});

test("colours are read in all the ways in which scene files write them", () => {
  const names = { skyblue: "#87ceeb" };
  expect(asColor([0, 0.5, 1], names)).toEqual([0, 0.5, 1]);
  expect(asColor("#fff", names)).toEqual([1, 1, 1]);
  expect(asColor("skyblue", names)?.[2]).toBeCloseTo(0.831, 3);
  for (const other of ["tiles", null, 3, [1, 2], { type: "checker" }]) expect(asColor(other, names)).toBeNull();
});

test("what is brighter than the screen is shown as white", () => {
  expect(toHex([11, 9, 7])).toBe("#ffffff");
});
