import { describe, expect, test } from "vitest";
import { clamp, dragged, duration, format, parse, stepOf, withPrefix } from "../src/json/numbers";

const free = { minimum: null, maximum: null };

describe("a number field", () => {
  test("reads what people type, and no more", () => {
    expect(parse(" 1,5 ")).toBe(1.5);
    expect(parse("−2e-3")).toBe(-0.002);
    expect(parse(".5")).toBe(0.5);
    for (const text of ["", "abc", "1.2.3", "0x10", "Infinity", "1e"]) expect(parse(text)).toBeNull();
  });

  test("works out sums", () => {
    expect(parse("0.5*2")).toBe(1);
    expect(parse("1 + 2*3 − 4/8")).toBe(6.5);
    expect(parse("-(0,1+0,2)×2")).toBe(-0.6);
    expect(parse("2e-1*-3")).toBe(-0.6);
    for (const text of ["1+", "*2", "(1", "1)", "1/0", "2 x 3", "1 2.3.4"]) expect(parse(text)).toBeNull();
  });

  test("shows what it reads, without trailing digits of binary fractions", () => {
    expect(format(0.1 + 0.2)).toBe("0.3");
    expect(format(-1.5)).toBe("−1.5");
    for (const value of [0, 1, -0.25, 12345, 1e-7, 8.6]) expect(parse(format(value))).toBe(value);
  });

  test("stays within its bounds", () => {
    expect(clamp(5, { minimum: 0, maximum: 1 })).toBe(1);
    expect(clamp(-5, { minimum: 0, maximum: null, minimumIsExclusive: true })).toBeGreaterThan(0);
    expect(clamp(2.6, { minimum: 1, maximum: 9, isInteger: true })).toBe(3);
  });

  test("changes by a hundredth or so while it is dragged, and comes back", () => {
    expect(dragged(1, 20, free, "normal")).toBe(2);
    expect(dragged(1, 20, free, "fine")).toBe(1.1);
    expect(dragged(1, 0, free, "normal")).toBe(1);
    expect(dragged(0.9, 2, free, "normal")).toBe(0.91);
    expect(dragged(4, 20, { minimum: 0, maximum: 255, isInteger: true }, "normal")).toBe(14);
    expect(dragged(0.5, 10_000, { minimum: 0, maximum: 1 }, "normal")).toBe(1);
  });

  test("has steps that are round powers of ten", () => {
    for (const value of [0, 0.003, 0.9, 8.6, 600, -37]) expect(Math.log10(stepOf(value, free)) % 1).toBeCloseTo(0);
  });
});

test("times and large numbers are said as people say them", () => {
  expect(duration(4.21)).toBe("4.2 s");
  expect(duration(187)).toBe("3:07");
  expect(duration(3725)).toBe("1:02:05");
  expect(withPrefix(31_400_000)).toBe("31.4 M");
  expect(withPrefix(0)).toBe("0 ");
});
