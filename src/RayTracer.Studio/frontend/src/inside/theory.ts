/** The line of slope −1/2 through the middle of the measured points: error falls as one over the square root of the samples. */
export function theoryLine(points: { samples: number; error: number }[]): number[] {
  const usable = points.filter((p) => p.error > 0);
  const middle = usable.map((p) => Math.log(p.error) + Math.log(p.samples) / 2).reduce((a, b) => a + b, 0) / (usable.length || 1);
  return points.map((p) => Math.exp(middle - Math.log(p.samples) / 2));
}
