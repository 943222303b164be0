import { signal } from "@preact/signals";
import { useEffect } from "preact/hooks";
import { get, post } from "../api/client";
import { Latest } from "../api/latest";
import type { GizmoAnswer, Vec3 } from "../api/types";
import { circle } from "../math/gizmo";
import type { GizmoKind } from "../math/gizmoChange";
import { project, unitsPerPixel, type Point } from "../math/projection";
import { add, axes, scale } from "../math/vec3";
import { isSeen, newGesture, type Placement } from "../state/edits";
import { complain } from "../state/messages";
import { revision, selection, tool } from "../state/store";
import { texts } from "../texts";
import { drag } from "./gizmoDrag";
import { cameraMoves, placement } from "./stage";

const gizmo = signal<GizmoAnswer | null>(null);
const handleLength = 72;
const keyStep = { move: 0.1, rotate: 5, scale: 1.05 };

const asked = new Latest<string>(async (pointer) => (gizmo.value = await get<GizmoAnswer>("view/gizmo", { pointer })), () => (gizmo.value = null));
const placing = new Latest<Placement[]>(async (all) => {
  for (const p of all) await post("document/place", p);
}, complain, (older, newer) => [...older, ...newer]);

const isTool = (name: string): name is GizmoKind => name === "move" || name === "rotate" || name === "scale";

/** Where a point of the world is on the stage. */
function seen(answer: GizmoAnswer, point: Vec3): Point | null {
  const { scale: zoom, left, top } = placement.value;
  const at = project(answer.camera, point);
  return at && { x: left + at.x * zoom, y: top + at.y * zoom };
}

/** Handles that move, turn or scale the selected shape. */
export function Gizmo() {
  const pointer = selection.value;
  const kind = tool.value;
  const isShown = isSeen(pointer) && isTool(kind) && !cameraMoves.value;
  useEffect(() => {
    if (isShown) asked.push(pointer);
    else gizmo.value = null;
  }, [pointer, isShown, revision.value]);

  const answer = gizmo.value;
  const center = answer && seen(answer, answer.center);
  if (!isShown || !answer || !center) return null;

  const size = handleLength * unitsPerPixel(answer.camera, answer.center) / placement.value.scale;
  const start = (e: PointerEvent, axis: number | null) => drag(e, kind, answer, axis, (change, gesture) => placing.push([{ pointer, ...change, gesture }]));
  const nudge = (e: KeyboardEvent, axis: number) => {
    const sign = { ArrowUp: 1, ArrowRight: 1, ArrowDown: -1, ArrowLeft: -1 }[e.key];
    if (!sign) return;
    const along = (n: number): Vec3 => scale(axes[axis]!, n);
    const factor = keyStep.scale ** sign;
    const change = {
      move: { translate: along(sign * keyStep.move) },
      rotate: { rotate: { axis: axes[axis]!, degrees: sign * keyStep.rotate, center: answer.center } },
      scale: { scale: axes[axis]!.map((a) => (a ? factor : 1)) as Vec3 },
    }[kind];
    placing.push([{ pointer, ...change, gesture: newGesture() }]);
    e.preventDefault();
    e.stopPropagation();
  };

  return (
    <svg class="gizmo" role="group" aria-label={texts.viewport.gizmo}>
      {axes.map((axis, i) => {
        const name = texts.panel.axes[i]!;
        const line = kind === "rotate"
          ? circle(answer.center, axis, size).map((p) => seen(answer, p)).filter((p) => p !== null)
          : [center, seen(answer, add(answer.center, scale(axis, size)))].filter((p) => p !== null);
        const end = line.at(-1);
        if (!end || line.length < 2) return null;
        const points = line.map((p) => `${p.x.toFixed(1)},${p.y.toFixed(1)}`).join(" ");
        return (
          <g class={`axis ${name}`} role="slider" tabIndex={0} aria-label={`${texts.viewport[kind]} ${name}`} aria-valuenow={0} aria-valuetext={name} data-handle={name} onPointerDown={(e) => start(e, i)} onKeyDown={(e) => nudge(e, i)}>
            <polyline class="grip" points={points} />
            <polyline class="line" points={points} />
            {kind === "move" && <circle class="tip" cx={end.x} cy={end.y} r="6" />}
            {kind === "scale" && <rect class="tip" x={end.x - 5.5} y={end.y - 5.5} width="11" height="11" />}
          </g>
        );
      })}
      {kind !== "rotate" && (
        <circle
          class="center"
          role="button"
          aria-label={kind === "move" ? texts.viewport.free : `${texts.viewport.scale} ${texts.viewport.all}`}
          data-handle="all"
          cx={center.x}
          cy={center.y}
          r="8"
          onPointerDown={(e) => start(e, null)}
        />
      )}
    </svg>
  );
}
