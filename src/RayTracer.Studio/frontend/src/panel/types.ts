/** What the schema says about a place of the scene. */

import { translated, translatedLight } from "./meaning";
import type { Json, CatalogueParameter, CatalogueType, TypeCatalogue } from "../api/types";

export type JsonObject = { [key: string]: Json };

export const isObject = (value: Json | undefined): value is JsonObject =>
  typeof value === "object" && value !== null && !Array.isArray(value);

/** The kind of a parameter, whether the server writes "Vector3" or "vector3". */
export const kindOf = (parameter: CatalogueParameter) => parameter.kind.charAt(0).toLowerCase() + parameter.kind.slice(1);

/** The record that describes a thing of this family and type; sections (camera, render …) have no family. */
export function findType(schema: TypeCatalogue, family: string | null, type: string | null): CatalogueType | null {
  if (!type) return null;
  const families = family && schema.types[family] ? [schema.types[family]] : Object.values(schema.types);
  return families.flat().find((t) => t.name === type) ?? schema.sections[type] ?? null;
}

/** The record that stands in a parameter of kind record or records. */
export const sectionOf = (schema: TypeCatalogue, parameter: CatalogueParameter): CatalogueType | null =>
  schema.sections[parameter.record ?? parameter.key] ?? null;

export const boundsOf = (parameter: CatalogueParameter) => ({
  minimum: parameter.minimum,
  maximum: parameter.maximum,
  minimumIsExclusive: parameter.minimumIsExclusive,
  isInteger: kindOf(parameter) === "integer",
});

/** A number gets a slider where all its range can sensibly be reached by one. */
export const hasSlider = (parameter: CatalogueParameter) =>
  parameter.minimum !== null && parameter.maximum !== null && parameter.maximum - parameter.minimum <= (kindOf(parameter) === "integer" ? 64 : 360);

/** A number, or the one that all channels of a colour are; null where it is neither. */
export function asNumber(value: Json | undefined): number | null {
  if (typeof value === "number") return value;
  const isGrey = Array.isArray(value) && value.length === 3 && typeof value[0] === "number" && value.every((v) => v === value[0]);
  return isGrey ? (value[0] as number) : null;
}

const numbersOf = (value: Json): number[] =>
  typeof value === "number" ? [value] : Array.isArray(value) ? value.flatMap(numbersOf) : [];

/** Whether what was written for one parameter may stand for another one of the same name. */
function fits(before: CatalogueParameter | undefined, now: CatalogueParameter, value: Json): boolean {
  if (!before || kindOf(before) !== kindOf(now) || before.record !== now.record) return false;
  if (typeof value === "number" && kindOf(now) === "texture" && !now.isNumber) return false;
  if (kindOf(now) === "choice") return now.choices.includes(String(value));
  return numbersOf(value).every((n) => n >= (now.minimum ?? -Infinity) && n <= (now.maximum ?? Infinity));
}

// What colours and roughnesses can be.
const kinds = new Set(["texture", "color", "number"]);

/** A value that a parameter can have; undefined where it is another kind of value, or out of range. */
function within(now: CatalogueParameter, value: Json | undefined): Json | undefined {
  const isNumber = typeof value === "number";
  if (value === undefined || (kindOf(now) === "number" ? !isNumber : isNumber && !now.isNumber)) return undefined;
  const limit = (n: number) => Math.min(Math.max(n, now.minimum ?? -Infinity), now.maximum ?? Infinity);
  return isNumber ? limit(value) : numbersOf(value).every((n) => n === limit(n)) ? value : undefined;
}

/** Another type in place of this one: what both of them know stays, where it means the same. */
export function retyped(value: Json | undefined, type: CatalogueType, before: CatalogueType | null, family: string | null = null): JsonObject {
  const result: JsonObject = { type: type.name };
  // What the old type knows; the name of another material is no colour.
  const meant = (key: string, v: Json) => key === "type" || before?.parameters.some((p) => p.key === key && (kindOf(p) !== "material" || isObject(v)));
  const old = Object.fromEntries(Object.entries(isObject(value) ? value : {}).filter(([key, v]) => meant(key, v)));
  for (const p of type.parameters) {
    const written = isObject(value) ? value[p.key] : undefined;
    const isSame = written !== undefined && fits(before?.parameters.find((q) => q.key === p.key), p, written);
    const kept = isSame ? written : family === "light" ? translatedLight(old, p.key, radiusOf(type, before)) : kinds.has(kindOf(p)) ? within(p, translated(old, type.name, p.key)) : undefined;
    if (kept !== undefined) result[p.key] = kept;
    else if (p.required) result[p.key] = p.default ?? requiredValue(kindOf(p));
  }
  return result;
}

// Of lamps of these types, where none is written.
function radiusOf(...types: (CatalogueType | null)[]): number {
  const byDefault = types.map((t) => t?.parameters.find((p) => p.key === "radius")?.default);
  return byDefault.find((r) => typeof r === "number") ?? 1;
}

const requiredValue = (kind: string): Json =>
  ({ texture: "white", color: "white", vector3: [0, 1, 0], vector2: [1, 1], number: 1, integer: 1, boolean: false, material: { type: "diffuse" } } as Record<string, Json>)[kind] ?? "";

/** "samplesPerPixel" as people read it: "samples per pixel". */
export const spaced = (key: string) => key.replace(/([a-z0-9])([A-Z])/g, (_, a: string, b: string) => `${a} ${b.toLowerCase()}`);
