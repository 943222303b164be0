import { signal } from "@preact/signals";
import { useEffect } from "preact/hooks";
import { post } from "../api/client";
import { Latest } from "../api/latest";
import type { GizmoHandles, GizmoKind, HandleDrag, Vec3 } from "../api/types";
import { axes, scale } from "../math/vec3";
import { isSeen, newGesture, type Placement } from "../state/edits";
import { complain } from "../state/messages";
import { documentState, selection, shownFrame, tool, viewState } from "../state/store";
import { texts } from "../texts";
import { drag } from "./gizmoDrag";
import { cameraMoves, movingFrames, placement, pointsOnStage } from "./stage";

const gizmo = signal<GizmoHandles | null>(null);
const handleLength = 72;
const keyStep = { move: 0.1, rotate: 5, scale: 1.05 };

type Question = { pointer: string; kind: GizmoKind; length: number };
const asked = new Latest<Question>(async (question) => (gizmo.value = await post<GizmoHandles>("view/gizmo", question)), () => (gizmo.value = null));
const dragging = new Latest<HandleDrag>((way) => post("view/drag", way), complain);
const placing = new Latest<Placement[]>(async (all) => {
  for (const p of all) await post("document/place", p);
}, complain, (older, newer) => [...older, ...newer]);

const isTool = (name: string): name is GizmoKind => name === "move" || name === "rotate" || name === "scale";

const onStage = (pixel: readonly [number, number]) => pointsOnStage([pixel])[0]!;

/** Handles that move, turn or scale the selected shape. */
export function Gizmo() {
  const pointer = selection.value;
  const kind = tool.value;
  const isShown = isSeen(pointer) && isTool(kind);
  const length = handleLength / placement.value.scale;
  useEffect(() => {
    if (isShown) asked.push({ pointer, kind, length });
    else gizmo.value = null;
  }, [pointer, kind, isShown, length, documentState.value?.builtRevision, viewState.value?.picture, shownFrame.value, movingFrames.value, cameraMoves.value]);

  const answer = gizmo.value;
  if (!isShown || !answer?.center || answer.kind !== kind) return null;

  const center = onStage(answer.center);
  const start = (e: PointerEvent, axis: number | null) => drag(e, (from, to, gesture) => dragging.push({ pointer, kind, axis, from, to, gesture }));
  const nudge = (e: KeyboardEvent, axis: number) => {
    const sign = { ArrowUp: 1, ArrowRight: 1, ArrowDown: -1, ArrowLeft: -1 }[e.key];
    if (!sign) return;
    const along = (n: number): Vec3 => scale(axes[axis]!, n);
    const factor = keyStep.scale ** sign;
    const change = {
      move: { translate: along(sign * keyStep.move) },
      rotate: { rotate: { axis: axes[axis]!, degrees: sign * keyStep.rotate, center: answer.middle } },
      scale: { scale: axes[axis]!.map((a) => (a ? factor : 1)) as Vec3 },
    }[kind];
    placing.push([{ pointer, ...change, gesture: newGesture() }]);
    e.preventDefault();
    e.stopPropagation();
  };

  return (
    <svg class="gizmo" role="group" aria-label={texts.viewport.gizmo}>
      {answer.handles.map(({ axis: i, points: pixels }) => {
        const name = texts.panel.axes[i]!;
        const line = pixels.map(onStage);
        const end = line.at(-1)!;
        const points = line.map((p) => `${p.x.toFixed(1)},${p.y.toFixed(1)}`).join(" ");
        return (
          <g class={`axis ${name}`} role="slider" tabindex={0} aria-label={`${texts.viewport[kind]} ${name}`} aria-valuenow={0} aria-valuetext={name} data-handle={name} onPointerDown={(e) => start(e, i)} onKeyDown={(e) => nudge(e, i)}>
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
