/** Moves of the camera that the picture is seen through; the scene's own moves on request only. */

import { post } from "../api/client";
import type { Vec3 } from "../api/types";
import { Latest } from "../api/latest";
import { newGesture } from "../state/edits";
import { complain } from "../state/messages";
import { mergeMoves, type Move, type MoveKind } from "./moves";
import { pace } from "./pace";
import { cameraMoves } from "./stage";

async function send(moves: Move[]): Promise<void> {
  try {
    for (const move of moves) await post("view/camera", move);
  } finally {
    if (moves.at(-1)?.end) cameraMoves.value = false;
  }
}

const latest = new Latest<Move[]>(send, complain, mergeMoves, () => pace.rest());

export function move(kind: MoveKind, gesture: string, dx: number, dy: number, dz = 0, around?: [number, number]): void {
  cameraMoves.value = true;
  latest.push([{ kind, dx, dy, dz, gesture, ...(around && { around }) }]);
}

export function endMove(kind: MoveKind, gesture: string): void {
  latest.push([{ kind, dx: 0, dy: 0, dz: 0, gesture, end: true }]);
  pace.hurry();
}

const burstPause = 350;
const bursts = new Map<MoveKind, { gesture: string; timer: number }>();

/** A move that has no natural end, such as a turn of the wheel or a pressed key: it ends when no other of its kind follows soon. */
export function moveInBurst(kind: MoveKind, dx: number, dy: number, dz = 0): void {
  const before = bursts.get(kind);
  clearTimeout(before?.timer);
  const gesture = before?.gesture ?? newGesture();
  const timer = window.setTimeout(() => {
    bursts.delete(kind);
    endMove(kind, gesture);
  }, burstPause);
  bursts.set(kind, { gesture, timer });
  move(kind, gesture, dx, dy, dz);
}

/** To the scene's own camera. */
export const cameraHome = () => post("view/camera", { kind: "home" });

/** The scene's own camera goes to where the view is. */
export const setCamera = () => post("view/camera/write");

/** Fills the picture with a thing, or with all. */
export const frame = (pointer: string | null) => post("view/camera", { kind: "frame", pointer });

/** Looks from a direction in the world. */
export const lookAlong = ([dx, dy, dz]: Vec3) => post("view/camera", { kind: "along", dx, dy, dz });

export const keepView = () => post("view/bookmark/add");
export const showView = (id: number) => post("view/bookmark/show", { id });
export const forgetView = (id: number) => post("view/bookmark/remove", { id });
