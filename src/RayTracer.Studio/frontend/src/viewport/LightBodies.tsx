import { signal } from "@preact/signals";
import { useEffect } from "preact/hooks";
import { get, post } from "../api/client";
import { Latest } from "../api/latest";
import type { LightBody, LightDrag } from "../api/types";
import { isLocked, select } from "../state/edits";
import { complain } from "../state/messages";
import { rightTab } from "../state/settings";
import { documentState, outline, selection, shownFrame, viewState } from "../state/store";
import { texts } from "../texts";
import { icons } from "../ui/Icon";
import { findNode } from "../outliner/find";
import { drag } from "./gizmoDrag";
import { cameraMoves, placement, pointsOnStage } from "./stage";

const bodies = signal<LightBody[]>([]);
const asked = new Latest<null>(async () => (bodies.value = await get<LightBody[]>("view/lights")), () => (bodies.value = []));
const dragging = new Latest<LightDrag>((way) => post("view/light/drag", way), complain);
const glyphs: Record<string, string> = { point: icons.light, spot: icons.spot, directional: icons.sun, sun: icons.sun };

/** Icons of the lights that no ray meets; the selected light's outline and handles. */
export function LightBodies() {
  const isShown = !cameraMoves.value;
  const shown = viewState.value?.picture;
  useEffect(() => {
    if (isShown) asked.push(null);
  }, [isShown, shown, documentState.value?.builtRevision, shownFrame.value, placement.value.scale]);
  if (!isShown || bodies.value.length === 0) return null;

  const choose = (pointer: string) => {
    // The sky is no thing of a list.
    rightTab.value = pointer === "/environment" ? "world" : "object";
    select(pointer);
  };
  return (
    <svg class="gizmo lights" role="group" aria-label={texts.viewport.lights}>
      {bodies.value.map((body) => {
        const isSelected = selection.value === body.pointer;
        const isFree = !isLocked(body.pointer);
        const [at] = pointsOnStage([body.place]);
        const name = findNode(outline.value, body.pointer)?.name ?? body.kind;
        return (
          <g key={body.pointer} class={isSelected ? "light selected" : "light"}>
            {isSelected && body.lines.map((line) => <polyline class="line" points={pointsOnStage(line).map((p) => `${p.x.toFixed(1)},${p.y.toFixed(1)}`).join(" ")} />)}
            {glyphs[body.kind] && isFree && (
              <g
                class="icon"
                role="button"
                tabindex={0}
                aria-label={texts.viewport.light(name)}
                aria-pressed={isSelected}
                data-handle="light"
                transform={`translate(${at!.x.toFixed(1)} ${at!.y.toFixed(1)})`}
                onClick={() => choose(body.pointer)}
                onKeyDown={(e) => (e.key === "Enter" || e.key === " ") && (choose(body.pointer), e.preventDefault(), e.stopPropagation())}
              >
                <circle r="12" />
                <path d={glyphs[body.kind]} transform="translate(-8 -8)" />
              </g>
            )}
            {isSelected && isFree && body.handles.map(({ kind, at: place }) => {
              const [p] = pointsOnStage([place]);
              // What a handle changes can be typed in the panel, by keyboard too.
              return (
                <circle
                  key={kind}
                  class={`grip-point ${kind}`}
                  aria-hidden="true"
                  data-handle={kind}
                  data-tip={texts.viewport.lightHandles[kind]}
                  cx={p!.x}
                  cy={p!.y}
                  r="7"
                  onPointerDown={(e) => drag(e, (_, to, gesture) => dragging.push({ pointer: body.pointer, kind, to, gesture }))}
                />
              );
            })}
          </g>
        );
      })}
    </svg>
  );
}
