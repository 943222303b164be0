/** How many pixels of a picture have which brightness of red, green and blue, as a screen shows it. */

export const binCount = 64;

export interface Histogram {
  /** Counts from black to white, of red, green and blue. */
  channels: number[][];
  /** The shares of the pixels that are black, and of those with a channel at its brightest. */
  black: number;
  white: number;
}

export function histogramOf(rgba: Uint8ClampedArray): Histogram {
  const channels = [0, 1, 2].map(() => new Array<number>(binCount).fill(0));
  let [black, white] = [0, 0];
  for (let i = 0; i < rgba.length; i += 4) {
    const [r, g, b] = [rgba[i]!, rgba[i + 1]!, rgba[i + 2]!];
    channels[0]![r >> 2]!++;
    channels[1]![g >> 2]!++;
    channels[2]![b >> 2]!++;
    if ((r | g | b) === 0) black++;
    if (r === 255 || g === 255 || b === 255) white++;
  }
  const pixels = Math.max(1, rgba.length / 4);
  return { channels, black: black / pixels, white: white / pixels };
}
