import { expect, test } from "vitest";
import type { CatalogueParameter, CatalogueType, TypeCatalogue } from "../src/api/types";
import { asNumber, boundsOf, findType, hasSlider, kindOf, retyped, spaced } from "../src/panel/types";

const parameter = (key: string, kind: string, more: Partial<CatalogueParameter> = {}): CatalogueParameter => ({
  key, kind, summary: "", unit: "", minimum: null, maximum: null, minimumIsExclusive: false, required: false, choices: [], default: null, range: "", family: null, record: null, isNumber: false, ...more,
});

const metal: CatalogueType = { name: "phongMetal", summary: "", addedAs: [], parameters: [parameter("color", "texture"), parameter("exponent", "number")] };
const image: CatalogueType = { name: "image", summary: "", addedAs: [], parameters: [parameter("file", "file", { required: true })] };
const schema = { schema: {}, types: { material: [metal], texture: [image] }, sections: { camera: { name: "camera", summary: "", addedAs: [], parameters: [] } }, refractiveIndices: [], colors: {}, maps: [] } as TypeCatalogue;

test("a type is found in its family, and sections by their names", () => {
  expect(findType(schema, "material", "phongMetal")).toBe(metal);
  expect(findType(schema, null, "camera")?.name).toBe("camera");
  expect(findType(schema, "material", "image")).toBeNull();
  expect(findType(schema, "material", null)).toBeNull();
});

test("another type keeps what it knows of the old one, and gets what it must have", () => {
  const diffuse: CatalogueType = { ...metal, name: "diffuse", parameters: [parameter("color", "texture")] };
  expect(retyped({ type: "diffuse", color: [1, 0, 0], roughness: 1 }, metal, diffuse)).toEqual({ type: "phongMetal", color: [1, 0, 0] });
  expect(retyped("red", image, null)).toEqual({ type: "image", file: "" });
});

test("what means the same under another name stays, both ways", () => {
  const type = (name: string, ...parameters: CatalogueParameter[]): CatalogueType => ({ name, summary: "", addedAs: [], parameters });
  const share = { minimum: 0, maximum: 1 };
  const diffuse = type("diffuse", parameter("color", "texture", share));
  const principled = type("principled", parameter("baseColor", "texture", share), parameter("roughness", "texture", { ...share, isNumber: true }));
  const rough = type("roughConductor", parameter("alpha", "texture", { ...share, isNumber: true }));
  const coated = type("diffuseSpecular", parameter("diffuse", "material"));
  const shining = type("luminaire", parameter("color", "texture"), parameter("exponent", "number"));
  const red = [0.72, 0.09, 0.06];
  expect(retyped({ type: "diffuse", color: red }, principled, diffuse)).toEqual({ type: "principled", baseColor: red });
  expect(retyped({ type: "principled", baseColor: "paint" }, diffuse, principled)).toEqual({ type: "diffuse", color: "paint" });
  expect(retyped({ type: "principled", roughness: 0.5 }, rough, principled)).toEqual({ type: "roughConductor", alpha: 0.25 });
  expect(retyped({ type: "roughConductor", alpha: 0.09 }, principled, rough)).toEqual({ type: "principled", roughness: 0.3 });
  expect(retyped({ type: "phongMetal", exponent: 198 }, rough, metal)).toEqual({ type: "roughConductor", alpha: 0.1 });
  expect(retyped({ type: "diffuseSpecular", diffuse: { type: "diffuse", color: red } }, principled, coated)).toEqual({ type: "principled", baseColor: red });
  expect(retyped({ type: "diffuseSpecular", diffuse: "paint" }, principled, coated)).toEqual({ type: "principled" });
  expect(retyped({ type: "luminaire", color: [40, 40, 40], exponent: 3 }, principled, shining)).toEqual({ type: "principled" });
  expect(retyped({ type: "phongMetal", color: [3, 0, 0] }, principled, metal)).toEqual({ type: "principled" });
});

test("a light of another type stays where it is, and as strong", () => {
  const type = (name: string, ...parameters: CatalogueParameter[]): CatalogueType => ({ name, summary: "", addedAs: [], parameters });
  const [position, direction, intensity] = [parameter("position", "vector3"), parameter("direction", "vector3"), parameter("intensity", "color")];
  const material = parameter("material", "material");
  const point = type("point", position, intensity);
  const spot = type("spot", position, direction, intensity, parameter("cutoffAngle", "number"));
  const sphere = type("sphere", parameter("center", "vector3"), parameter("radius", "number", { default: 1 }), material);
  const disk = type("disk", parameter("center", "vector3"), parameter("normal", "vector3"), parameter("radius", "number", { default: 1 }), material);
  const lamp = { type: "point", position: [1, 2, 3], intensity: [6.2832, 0, 3.1416] };
  expect(retyped(lamp, spot, point, "light")).toEqual({ ...lamp, type: "spot" });
  expect(retyped({ ...lamp, direction: [1, 0, 0] }, disk, spot, "light")).toEqual({ type: "disk", center: [1, 2, 3], normal: [1, 0, 0], material: { type: "luminaire", color: [2, 0, 1] } });
  const ball = { type: "sphere", center: [1, 2, 3], radius: 0.5, material: { type: "luminaire", color: [2, 1, 0], multiplier: 4 } };
  expect(retyped(ball, point, sphere, "light")).toEqual({ type: "point", position: [1, 2, 3], intensity: [6.28, 3.14, 0] });
  expect(retyped(ball, disk, sphere, "light")).toEqual({ ...ball, type: "disk" });
  expect(retyped({ type: "sphere", material: "lamp" }, point, sphere, "light")).toEqual({ type: "point" });
});

test("what has the same name but another meaning or range does not stay", () => {
  const types = (more: Partial<CatalogueParameter>): CatalogueType => ({ ...metal, parameters: [parameter("a", "texture", more)] });
  const kept = (value: CatalogueParameter["default"], before: Partial<CatalogueParameter>, now: Partial<CatalogueParameter>) => retyped({ a: value }, types(now), types(before)).a;
  expect(kept([5, 5, 5], {}, { maximum: 1 })).toBeUndefined();
  expect(kept([1, 0, 1], {}, { maximum: 1 })).toEqual([1, 0, 1]);
  expect(kept(0.5, { isNumber: true }, {})).toBeUndefined();
  expect(kept(0.5, { isNumber: true }, { isNumber: true })).toBe(0.5);
  expect(kept("gold", { kind: "choice", choices: ["gold"] }, { kind: "choice", choices: ["iron"] })).toBeUndefined();
  expect(kept({ type: "diffuse" }, { kind: "material" }, {})).toBeUndefined();
});

test("a grey is a number where one may stand", () => {
  expect(asNumber([0.25, 0.25, 0.25])).toBe(0.25);
  expect(asNumber([0.25, 0.5, 0.25])).toBeNull();
  expect(asNumber("white")).toBeNull();
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
