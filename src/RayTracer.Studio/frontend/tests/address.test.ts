import { expect, test } from "vitest";
import { readAddress, writeAddress } from "../src/inside/pixelAddress";

test("an address names a pixel and a sample, and is read as it was written", () => {
  expect(writeAddress({ x: 216, y: 359, sample: 3 })).toBe("#pixel=216,359&sample=3");
  expect(readAddress("#pixel=216,359&sample=3")).toEqual({ x: 216, y: 359, sample: 3 });
  expect(readAddress("#pixel=7,8")).toEqual({ x: 7, y: 8, sample: 0 });
});

test("other addresses name none", () => {
  for (const hash of ["", "#", "#sample=3", "#pixel=a,b", "#pixel=-1,2"]) expect(readAddress(hash)).toBeNull();
});
