/** A pixel and one of its samples, as they stand in an address. */

export interface PixelAddress {
  x: number;
  y: number;
  sample: number;
}

/** What an address says; null where it names no pixel. */
export function readAddress(hash: string): PixelAddress | null {
  const pixel = /[#&]pixel=(\d+),(\d+)/.exec(hash);
  if (!pixel) return null;
  return { x: Number(pixel[1]), y: Number(pixel[2]), sample: Number(/[#&]sample=(\d+)/.exec(hash)?.[1] ?? 0) };
}

export const writeAddress = ({ x, y, sample }: PixelAddress) => `#pixel=${x},${y}&sample=${sample}`;
