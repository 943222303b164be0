/** Keys that move the camera while the picture has the focus. */

import { newGesture } from "../state/edits";
import { endMove, move, moveInBurst } from "./camera";

const keyStep = 0.04;
const flySpeed = 0.6;
const oneFrame = 1 / 60;

const flyDirections: Record<string, [number, number, number]> = {
  KeyW: [0, 0, 1], KeyS: [0, 0, -1], KeyA: [-1, 0, 0], KeyD: [1, 0, 0], KeyE: [0, -1, 0], KeyQ: [0, 1, 0],
};

const held = new Set<string>();
let flight = "";

function advance(seconds: number): void {
  const way = flySpeed * seconds;
  const sum = [...held].map((key) => flyDirections[key]!).reduce((a, b) => [a[0] + b[0], a[1] + b[1], a[2] + b[2]]);
  move("translate", flight, sum[0] * way, sum[1] * way, sum[2] * way);
}

function fly(before: number): void {
  requestAnimationFrame((now) => {
    if (held.size === 0) {
      endMove("translate", flight);
      flight = "";
      return;
    }
    advance(Math.min((now - before) / 1000, 0.1));
    fly(now);
  });
}

/** Whether the key moves the camera; then it has done so. */
export function onCameraKey(e: KeyboardEvent): boolean {
  if (e.ctrlKey || e.metaKey || e.altKey) return false;
  if (e.code in flyDirections) {
    held.add(e.code);
    if (!flight) {
      flight = newGesture();
      // So that a press without a frame in it moves too.
      advance(oneFrame);
      fly(performance.now());
    }
    return true;
  }
  const arrows: Record<string, [number, number]> = { ArrowLeft: [-keyStep, 0], ArrowRight: [keyStep, 0], ArrowUp: [0, -keyStep], ArrowDown: [0, keyStep] };
  const arrow = arrows[e.key];
  if (arrow) moveInBurst(e.shiftKey ? "pan" : "orbit", ...arrow);
  else if (e.key === "+" || e.key === "=") moveInBurst("dolly", 0, -keyStep);
  else if (e.key === "-") moveInBurst("dolly", 0, keyStep);
  else return false;
  return true;
}

export const onCameraKeyUp = (e: KeyboardEvent) => held.delete(e.code);
export const releaseKeys = () => held.clear();
