import { useEffect, useState } from "preact/hooks";
import { get } from "../api/client";
import type { MotionPaths as Paths } from "../api/types";
import { isSeen } from "../state/edits";
import { revision, selection, shownFrame, time } from "../state/store";
import { texts } from "../texts";
import { cameraMoves, picture, placement } from "../viewport/stage";
import { showsPaths } from "./drag";

const t = texts.timeline;
type Place = readonly [number, number] | null;

/** A line through places of the picture, with gaps where they are behind the eye. */
export function pathOf(places: readonly Place[]): string {
  return places.map((p, i) => (p ? `${places[i - 1] ? "L" : "M"}${p[0].toFixed(1)} ${p[1].toFixed(1)}` : "")).join("");
}

function Way({ places, step, kind, title }: { places: readonly Place[]; step: number; kind: string; title: string }) {
  const { scale, left, top } = placement.value;
  const onStage = places.map((p): Place => p && [left + p[0] * scale, top + p[1] * scale]);
  const now = onStage[Math.round((shownFrame.value ?? 0) / step)];
  return (
    <>
      <path class={kind} d={pathOf(onStage)}><title>{title}</title></path>
      {onStage.map((p) => p && <circle class={`${kind}-dot`} cx={p[0]} cy={p[1]} r={2} />)}
      {now && <circle class={`${kind}-dot`} cx={now[0]} cy={now[1]} r={5} />}
    </>
  );
}

/** The ways of the camera and the selected thing, over the picture. */
export function MotionPaths() {
  const [paths, setPaths] = useState<Paths | null>(null);
  const pointer = isSeen(selection.value) ? selection.value : null;
  const isShown = showsPaths.value && (time.value?.frames ?? 0) > 0 && !cameraMoves.value;
  useEffect(() => {
    if (!isShown) return setPaths(null);
    const abort = new AbortController();
    get<Paths>("timeline/paths", { pointer }, abort.signal).then(setPaths, () => undefined);
    return () => abort.abort();
  }, [isShown, pointer, revision.value, shownFrame.value, picture.value.width, picture.value.height]);
  if (!isShown || !paths) return null;
  return (
    <svg class="motion-paths" aria-hidden="true">
      <Way places={paths.camera as readonly Place[]} step={paths.step} kind="camera" title={t.camera} />
      <Way places={paths.thing as readonly Place[]} step={paths.step} kind="thing" title={t.thing} />
    </svg>
  );
}
