import { describe, expect, test } from "vitest";
import { at, contains, join, last, parent, split } from "../src/json/pointer";

describe("a JSON pointer", () => {
  test("escapes slashes and tildes in keys, and gives them back", () => {
    const pointer = join("/materials", "a/b~c");
    expect(pointer).toBe("/materials/a~1b~0c");
    expect(split(pointer)).toEqual(["materials", "a/b~c"]);
    expect(last(pointer)).toBe("a/b~c");
  });

  test("finds values in objects and arrays, and nothing where there is nothing", () => {
    const value = { shapes: [{ radius: 2 }], "": 3 };
    expect(at(value, "")).toBe(value);
    expect(at(value, "/shapes/0/radius")).toBe(2);
    expect(at(value, "/")).toBe(3);
    expect(at(value, "/shapes/1/radius")).toBeUndefined();
    expect(at(value, "/shapes/0/radius/deeper")).toBeUndefined();
  });

  test("knows its parent and what it contains", () => {
    expect(parent("/shapes/3")).toBe("/shapes");
    expect(parent("/camera")).toBe("");
    expect(contains("/shapes/1", "/shapes/1/material")).toBe(true);
    expect(contains("/shapes/1", "/shapes/12")).toBe(false);
  });
});
