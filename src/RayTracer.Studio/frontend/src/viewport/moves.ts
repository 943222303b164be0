export type MoveKind = "orbit" | "pan" | "zoom" | "dolly" | "translate" | "rotate";

/** One step of a gesture; dx and dy are fractions of the picture's height. */
export interface Move {
  kind: MoveKind;
  dx: number;
  dy: number;
  dz: number;
  gesture: string;
  end?: boolean;
  /** The pixel where the gesture began: an orbit turns around what is seen there. */
  around?: [number, number];
}

/** Moves of one kind and gesture become one; others follow each other. */
export function mergeMoves(older: Move[], newer: Move[]): Move[] {
  const result = [...older];
  for (const move of newer) {
    const last = result.at(-1);
    if (last && last.kind === move.kind && last.gesture === move.gesture && !last.end) {
      const end = move.end ? { end: true } : {};
      result[result.length - 1] = { ...last, dx: last.dx + move.dx, dy: last.dy + move.dy, dz: last.dz + move.dz, ...end };
    } else {
      result.push(move);
    }
  }
  return result;
}
