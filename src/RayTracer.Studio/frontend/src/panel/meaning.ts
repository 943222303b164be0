/** What materials have in common under different names: their colour, and how rough they are. */

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
