import { readFileSync } from "node:fs";
import { describe, expect, test } from "vitest";
import { complete, describe as explain } from "../src/editor/assist";
import { SchemaGuide, type Schema } from "../src/json/schema";

const schema = JSON.parse(readFileSync(new URL("../../../../scenes/raytracer.schema.json", import.meta.url), "utf8")) as Schema;
const guide = new SchemaGuide(schema);

const labels = (marked: string) => {
  const result = complete(marked.replace("|", ""), marked.indexOf("|"), guide);
  return (result?.options ?? []).map((o) => JSON.parse(o.label) as unknown);
};

describe("completion", () => {
  test("offers the keys of the scene, but not those that are there", () => {
    const found = labels('{ "camera": {}, "|" }');
    expect(found).toContain("shapes");
    expect(found).not.toContain("camera");
  });

  test("offers the keys of the type that is written", () => {
    const found = labels('{ "shapes": [ { "type": "sphere", | } ] }');
    expect(found).toEqual(expect.arrayContaining(["center", "radius", "material"]));
    expect(found).not.toContain("tubeRadius");
  });

  test("offers every type where a type is to be written, whatever stands there", () => {
    expect(labels('{ "shapes": [ { "type": "sp|" } ] }')).toEqual(expect.arrayContaining(["sphere", "torus", "box"]));
    expect(labels('{ "materials": { "a": { "type": "diffuse|" } } }')).toEqual(expect.arrayContaining(["phongMetal", "dielectric"]));
  });

  test("offers choices, true and false, colours, and names that the scene defines", () => {
    expect(labels('{ "render": { "sampler": "|" } }')).toEqual(expect.arrayContaining(["sobol", "jittered"]));
    expect(labels('{ "background": "|" }')).toContain("skyblue");
    expect(labels('{ "materials": { "glass": { "type": "dielectric" } }, "shapes": [ { "type": "sphere", "material": "|" } ] }')).toContain("glass");
    expect(labels('{ "shapes": [ { "type": "cone", "caps": | } ] }')).toEqual(expect.arrayContaining([true, false]));
  });

  test("is silent in comments", () => {
    expect(labels('{ // "|\n }')).toEqual([]);
    expect(labels('{ /* "| */ }')).toEqual([]);
    expect(labels('{ /* c */ "|" }')).not.toEqual([]);
  });

  test("replaces what is written, quotes and all", () => {
    const text = '{ "render": { "sampler": "sob" } }';
    expect(complete(text, text.indexOf("sob") + 3, guide)).toMatchObject({ from: text.indexOf('"sob'), to: text.indexOf('"sob') + 5 });
  });

  test("has an answer at every place of a scene that is being typed", () => {
    const text = '{ "materials": { "m": { "type": "diffuse", "color": [1, 0, 0] } }, "shapes": [ { "type": "sphere", "radius": 2 } ] }';
    for (let i = 0; i <= text.length; i++) expect(() => complete(text.slice(0, i), i, guide)).not.toThrow();
  });
});

describe("hovering", () => {
  const text = '{ "shapes": [ { "type": "sphere", "radius": 2 } ] }';

  test("says what a key means, with its default", () => {
    expect(explain(text, text.indexOf("radius") + 2, guide)?.text).toMatch(/radius.*Default: 1/i);
  });

  test("says what a type is", () => {
    expect(explain(text, text.indexOf("sphere") + 2, guide)?.text).toMatch(/sphere/i);
  });

  test("says nothing where there is nothing to say", () => {
    expect(explain(text, text.indexOf("2"), guide)).toBeNull();
  });
});
