import { readFileSync, readdirSync } from "node:fs";
import { describe, expect, test } from "vitest";
import { locate, nodeAt, parseJsonc, plain } from "../src/json/jsonc";

const where = (text: string) => {
  const position = text.indexOf("|");
  return locate(parseJsonc(text.replace("|", "")), position);
};

describe("the tolerant parser", () => {
  test("reads comments and trailing commas as if they were not there", () => {
    expect(plain(parseJsonc('// a\n{ "a": [1, 2.5e1, /* b */ true,], "b": { "c": "x\\n" }, }'))).toEqual({ a: [1, 25, true], b: { c: "x\n" } });
  });

  test("reads every shipped scene as the strict parser reads it without comments", () => {
    const folder = new URL("../../../../scenes/report/", import.meta.url);
    const files = readdirSync(folder).filter((f) => f.endsWith(".json"));
    expect(files.length).toBeGreaterThan(2);
    for (const file of files) {
      const text = readFileSync(new URL(file, folder), "utf8");
      const strict = text.replace(/"(?:[^"\\]|\\.)*"|\/\/[^\n]*/g, (m) => (m.startsWith('"') ? m : "")).replace(/,(\s*[}\]])/g, "$1");
      expect(plain(parseJsonc(text))).toEqual(JSON.parse(strict));
    }
  });

  test("ends on every beginning of a scene, whatever was just being typed", () => {
    const text = '{ "shapes": [ { "type": "sphere", "center": [0, 1.5, -2], /* c */ "name": "a \\" b" } ] } // end';
    for (let i = 0; i <= text.length; i++) {
      const root = parseJsonc(text.slice(0, i));
      for (let p = 0; p <= i; p++) expect(Array.isArray(locate(root, p).path)).toBe(true);
    }
  });

  test("knows the key and the value that a position is in", () => {
    expect(where('{ "shapes": [ { "ra|": 1 } ] }')).toMatchObject({ path: ["shapes", 0], key: { key: "ra" } });
    expect(where('{ "shapes": [ { "type": "sph|" } ] }')).toMatchObject({ path: ["shapes", 0, "type"], node: { kind: "string" } });
    expect(where('{ "camera": { | } }')).toMatchObject({ path: ["camera"], node: { kind: "object" }, key: null });
    expect(where('{ "camera": { "position": [0, |] } }')).toMatchObject({ path: ["camera", "position"], node: { kind: "array" } });
    expect(where('{ "background": | }').path).toEqual(["background"]);
  });

  test("finds nodes by path", () => {
    expect(nodeAt(parseJsonc('{"a": [{"b": 7}]}'), ["a", 0, "b"])?.value).toBe(7);
    expect(nodeAt(parseJsonc("{}"), ["a"])).toBeNull();
  });
});
