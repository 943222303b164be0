/** The outline of a thing in the picture, from the pixels that show it. */

import type { PixelMask } from "../api/types";

/** 1 for each pixel that lies outside of the thing and within `reach` pixels of it. */
export function outlineOf({ width, height, runs }: PixelMask, reach: number): Uint8Array {
  const inside = new Uint8Array(width * height);
  for (let i = 0; i + 1 < runs.length; i += 2) inside.fill(1, runs[i], runs[i]! + runs[i + 1]!);

  // A square around each pixel, first along rows, then along columns.
  const wide = new Uint8Array(inside.length);
  for (let i = 0; i + 1 < runs.length; i += 2) {
    const start = runs[i]!;
    const end = start + runs[i + 1]!;
    // A run may go on into the next rows.
    for (let from = start; from < end; ) {
      const row = Math.floor(from / width) * width;
      const to = Math.min(end, row + width);
      wide.fill(1, Math.max(row, from - reach), Math.min(row + width, to + reach));
      from = to;
    }
  }
  const result = new Uint8Array(inside.length);
  for (let y = 0; y < height; y++) {
    for (let dy = -reach; dy <= reach; dy++) {
      const other = y + dy;
      if (other < 0 || other >= height) continue;
      for (let x = 0; x < width; x++) if (wide[other * width + x]) result[y * width + x] = 1;
    }
  }
  for (let i = 0; i < result.length; i++) if (inside[i]) result[i] = 0;
  return result;
}
