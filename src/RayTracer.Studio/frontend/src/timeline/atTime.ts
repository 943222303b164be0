/** Animated values in the panel. */

import type { AnimatedValue, Json } from "../api/types";

/** A value as it is at the frame that is shown: animated as a whole, or some of its numbers. */
export function atTime(pointer: string, value: Json | undefined, animated: readonly AnimatedValue[]): Json | undefined {
  let result = value;
  for (const a of animated) {
    if (a.value === null) continue;
    if (a.pointer === pointer) result = a.value;
    const number = a.pointer.startsWith(`${pointer}/`) ? a.pointer.slice(pointer.length + 1) : "";
    if (/^\d+$/.test(number) && Array.isArray(result)) result = result.map((n, i) => (i === Number(number) ? a.value : n));
  }
  return result;
}

/** What is animated of a value: all of it, or some of its numbers. */
export const animatedAt = (pointer: string, animated: readonly AnimatedValue[]) =>
  animated.filter((a) => a.pointer === pointer || (a.pointer.startsWith(`${pointer}/`) && /^\d+$/.test(a.pointer.slice(pointer.length + 1))));
