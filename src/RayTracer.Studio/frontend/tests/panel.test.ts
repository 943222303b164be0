import { expect, test } from "vitest";
import type { Parameter, RecordType, SchemaAnswer } from "../src/api/types";
import { boundsOf, findType, hasSlider, kindOf, retyped, spaced } from "../src/panel/types";

const parameter = (key: string, kind: string, more: Partial<Parameter> = {}): Parameter => ({
  key, kind, summary: "", unit: "", minimum: null, maximum: null, minimumIsExclusive: false, required: false, choices: [], default: null, range: "", family: null, record: null, ...more,
});

const metal: RecordType = { name: "phongMetal", summary: "", parameters: [parameter("color", "texture"), parameter("exponent", "number")] };
const image: RecordType = { name: "image", summary: "", parameters: [parameter("file", "file", { required: true })] };
const schema = { schema: {}, types: { material: [metal], texture: [image] }, sections: { camera: { name: "camera", summary: "", parameters: [] } }, refractiveIndices: [], colors: {} } as SchemaAnswer;

test("a type is found in its family, and sections by their names", () => {
  expect(findType(schema, "material", "phongMetal")).toBe(metal);
  expect(findType(schema, null, "camera")?.name).toBe("camera");
  expect(findType(schema, "material", "image")).toBeNull();
  expect(findType(schema, "material", null)).toBeNull();
});

test("another type keeps what it knows of the old one, and gets what it must have", () => {
  expect(retyped({ type: "diffuse", color: [1, 0, 0], roughness: 1 }, metal)).toEqual({ type: "phongMetal", color: [1, 0, 0] });
  expect(retyped("red", image)).toEqual({ type: "image", file: "" });
});

test("numbers have sliders where the whole range can be reached by one", () => {
  expect(hasSlider(parameter("r0", "number", { minimum: 0, maximum: 1 }))).toBe(true);
  expect(hasSlider(parameter("width", "integer", { minimum: 1, maximum: 65536 }))).toBe(false);
  expect(hasSlider(parameter("radius", "number", { minimum: 0 }))).toBe(false);
});

test("kinds and keys are read as the server and people write them", () => {
  expect(kindOf(parameter("a", "Vector3"))).toBe("vector3");
  expect(boundsOf(parameter("a", "Integer", { minimum: 1 }))).toMatchObject({ minimum: 1, isInteger: true });
  expect(spaced("samplesPerPixel")).toBe("samples per pixel");
  expect(spaced("uvA")).toBe("uv a");
});
