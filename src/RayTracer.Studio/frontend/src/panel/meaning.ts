/** What types have in common under different names: the colour of materials and how rough they are; where lights are, where they shine, and how strongly. */

import type { Json } from "../api/types";

/** The parameters that are a surface's colour, in the order in which they are looked for. */
const colors = ["color", "baseColor", "diffuse"];

/** Parameters that say how rough a surface is, to and from the width of its microfacets' slopes. */
const roughnesses: Record<string, { toAlpha: (n: number) => number; fromAlpha: (alpha: number) => number }> = {
  alpha: { toAlpha: (n) => n, fromAlpha: (alpha) => alpha },
  roughness: { toAlpha: (n) => n * n, fromAlpha: Math.sqrt },
  // The exponent of the lobe that is about as wide.
  exponent: { toAlpha: (n) => Math.sqrt(2 / (n + 2)), fromAlpha: (alpha) => 2 / Math.max(alpha * alpha, 1e-6) - 2 },
};

/** Light has a colour and an exponent too, but they mean something else. */
const shines = (type: unknown) => type === "luminaire";

const isRecord = (value: Json | undefined): value is { [key: string]: Json } => typeof value === "object" && value !== null && !Array.isArray(value);

/** The value that means for a parameter of another type what the old one had under another name; undefined where nothing does. */
export function translated(old: { [key: string]: Json }, type: string, key: string): Json | undefined {
  if (shines(old.type) || shines(type)) return undefined;
  if (colors.includes(key)) {
    const found = colors.filter((c) => c !== key).map((c) => old[c]).find((v) => v !== undefined);
    // Of a coated material, the colour is that of what is under the coat.
    return isRecord(found) && found.type === "diffuse" ? found.color : found;
  }
  const target = roughnesses[key];
  const source = target && Object.keys(roughnesses).find((r) => r !== key && typeof old[r] === "number");
  if (!target || !source) return undefined;
  const value = target.fromAlpha(roughnesses[source]!.toAlpha(old[source] as number));
  return Number.isFinite(value) ? Number(value.toPrecision(3)) : undefined;
}

type Vector = [number, number, number];

const isVector = (value: Json | undefined): value is Vector => Array.isArray(value) && value.length === 3 && value.every((v) => typeof v === "number");
const sameOfLights: Record<string, string> = { position: "center", center: "position", direction: "normal", normal: "direction" };

/**
 * The same of lights. Round lamps and lights without extent shine equally far: intensity is radiance times the area that is seen, π r². Only a
 * luminaire that is written in place and shines equally in all directions is known.
 */
export function translatedLight(old: { [key: string]: Json }, key: string, radius: number): Json | undefined {
  const other = sameOfLights[key];
  if (other) return isVector(old[other]) ? old[other] : undefined;
  const area = (r: Json | undefined) => Math.PI * (typeof r === "number" ? r : radius) ** 2;
  const times = (color: Vector, factor: number) => color.map((c) => Number((c * factor).toPrecision(3)));
  const material = old.material;
  if (key === "intensity" && isRecord(material) && material.type === "luminaire" && !material.exponent) {
    const color = isVector(material.color) ? material.color : ([1, 1, 1] satisfies Vector);
    return times(color, (typeof material.multiplier === "number" ? material.multiplier : 1) * area(old.radius));
  }
  if (key === "material" && isVector(old.intensity)) return { type: "luminaire", color: times(old.intensity, 1 / area(old.radius)) };
  return undefined;
}
