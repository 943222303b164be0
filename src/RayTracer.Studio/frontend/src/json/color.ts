/** Colours: linear sRGB as the renderer calculates, and "#rrggbb" as screens show. The curve is IEC 61966-2-1's. */

import type { Json, Vec3 } from "../api/types";

const toScreen = (c: number) => (c <= 0.0031308 ? 12.92 * c : 1.055 * c ** (1 / 2.4) - 0.055);
const toLinear = (c: number) => (c <= 0.04045 ? c / 12.92 : ((c + 0.055) / 1.055) ** 2.4);

export function toHex(color: Vec3): string {
  const byte = (c: number) => Math.round(toScreen(Math.min(1, Math.max(0, c))) * 255);
  return `#${color.map((c) => byte(c).toString(16).padStart(2, "0")).join("")}`;
}

/** The linear colour of "#rrggbb", with as many digits as eight bits can tell apart. */
export function fromHex(hex: string): Vec3 {
  const long = hex.length === 4 ? hex.replace(/[0-9a-f]/gi, "$&$&") : hex;
  const channel = (i: number) => Number(toLinear(parseInt(long.slice(1 + 2 * i, 3 + 2 * i), 16) / 255).toFixed(4));
  return [channel(0), channel(1), channel(2)];
}

export const isHex = (text: string) => /^#([0-9a-f]{3}|[0-9a-f]{6})$/i.test(text);

/** A written colour as linear numbers; null where it is not a colour (such as a texture's name). */
export function asColor(value: Json | undefined, names: Record<string, string>): Vec3 | null {
  if (Array.isArray(value) && value.length === 3 && value.every((v) => typeof v === "number")) return value as Vec3;
  if (typeof value !== "string") return null;
  if (isHex(value)) return fromHex(value);
  const named = names[value];
  return named ? fromHex(named) : null;
}
