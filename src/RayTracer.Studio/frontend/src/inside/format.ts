import { format } from "../json/numbers";

/** A radiance or weight in short: one number where the channels agree. */
export function rgb(color: readonly number[], digits = 3): string {
  const shown = color.map((c) => format(c, digits));
  return shown[0] === shown[1] && shown[1] === shown[2] ? shown[0]! : shown.join(" ");
}
