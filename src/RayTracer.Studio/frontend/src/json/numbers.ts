/** Numbers as people read and change them. */

/** A number with at most `digits` significant digits and no trailing zeros. */
export function format(value: number, digits = 6): string {
  if (!Number.isFinite(value)) return value > 0 ? "∞" : value < 0 ? "−∞" : "–";
  const rounded = Number(value.toPrecision(digits));
  return String(rounded).replace("-", "−");
}

const numberAt = /^(\d+\.?\d*|\.\d+)(e[+-]?\d+)?/i;

/**
 * Reads what a person typed: a number or a sum such as 0.5*2 or (1+2)/3. A decimal comma or a real minus sign is fine; null where it comes to
 * no number.
 */
export function parse(text: string): number | null {
  let rest = text.replace(/−/g, "-").replace(/,/g, ".").replace(/[×·]/g, "*").replace(/\s+/g, "");
  const take = (signs: string): string => {
    const sign = rest.charAt(0);
    if (!sign || !signs.includes(sign)) return "";
    rest = rest.slice(1);
    return sign;
  };
  const factor = (): number => {
    if (take("-")) return -factor();
    if (take("+")) return factor();
    if (take("(")) {
      const inner = sum();
      return take(")") ? inner : NaN;
    }
    const number = numberAt.exec(rest)?.[0] ?? "";
    rest = rest.slice(number.length);
    return number ? Number(number) : NaN;
  };
  const product = (): number => {
    let value = factor();
    for (let sign = take("*/"); sign; sign = take("*/")) value = sign === "*" ? value * factor() : value / factor();
    return value;
  };
  const sum = (): number => {
    let value = product();
    for (let sign = take("+-"); sign; sign = take("+-")) value = sign === "+" ? value + product() : value - product();
    return value;
  };
  const value = sum();

  // The last digits of a sum are those of binary fractions.
  return rest === "" && Number.isFinite(value) ? Number(value.toPrecision(12)) : null;
}

const units: [number, string][] = [[1e9, "G"], [1e6, "M"], [1e3, "k"]];

/** A large number with a prefix, ready for its unit: "31.4 M", "120 ". */
export function withPrefix(value: number): string {
  const [factor, prefix] = units.find(([limit]) => Math.abs(value) >= limit) ?? [1, ""];
  return `${format(value / factor, 3)} ${prefix}`;
}

/** Seconds as a person says them: 4.2 s, 3:07, 1:02:05. */
export function duration(seconds: number): string {
  if (seconds < 10) return `${seconds.toFixed(1)} s`;
  if (seconds < 60) return `${Math.round(seconds)} s`;
  const whole = Math.round(seconds);
  const two = (n: number) => String(n).padStart(2, "0");
  const minutes = Math.floor(whole / 60);
  return minutes < 60
    ? `${minutes}:${two(whole % 60)}`
    : `${Math.floor(minutes / 60)}:${two(minutes % 60)}:${two(whole % 60)}`;
}

export interface Bounds {
  minimum: number | null;
  maximum: number | null;
  minimumIsExclusive?: boolean;
  isInteger?: boolean;
}

export function clamp(value: number, bounds: Bounds): number {
  let result = bounds.isInteger ? Math.round(value) : value;
  if (bounds.maximum !== null) result = Math.min(result, bounds.maximum);
  if (bounds.minimum !== null) {
    const smallest = bounds.minimumIsExclusive ? bounds.minimum + (bounds.isInteger ? 1 : 1e-4) : bounds.minimum;
    result = Math.max(result, smallest);
  }
  return result;
}

export type Speed = "fine" | "normal" | "coarse";
const factors: Record<Speed, number> = { fine: 0.1, normal: 1, coarse: 10 };

/** How much one step (an arrow key, or a few pixels of dragging) changes a number: about a hundredth of it, a round power of ten. */
export function stepOf(value: number, bounds: Bounds, speed: Speed = "normal"): number {
  if (bounds.isInteger) return Math.max(1, Math.round(factors[speed] * (Math.abs(value) >= 1000 ? 10 : 1)));
  const span = bounds.minimum !== null && bounds.maximum !== null ? bounds.maximum - bounds.minimum : Infinity;
  const size = Math.min(Math.max(Math.abs(value), 0.1), span);
  return 10 ** Math.floor(Math.log10(size) - 1) * factors[speed];
}

/** The number after dragging by `pixels`; the start's step counts for the whole drag, so that going back gives the start again. */
export function dragged(start: number, pixels: number, bounds: Bounds, speed: Speed): number {
  const step = stepOf(start, bounds, speed);
  return tidy(clamp(start + Math.round(pixels / 2) * step, bounds), step);
}

/** Takes away what binary fractions add: a multiple of a step of 0.01 has two decimals. */
export function tidy(value: number, step: number): number {
  const decimals = Math.max(0, Math.ceil(-Math.log10(step) - 1e-9));
  return Number(value.toFixed(Math.min(decimals + 2, 12)));
}

/** A moment as 2026-11-24 15:30, in the user's time: read the same everywhere. */
export function moment(time: string): string {
  const at = new Date(time);
  const two = (n: number) => String(n).padStart(2, "0");
  return `${at.getFullYear()}-${two(at.getMonth() + 1)}-${two(at.getDate())} ${two(at.getHours())}:${two(at.getMinutes())}`;
}
