import { time } from "../state/store";
import { texts } from "../texts";
import { showFrame } from "./frames";

const wanted = 12;

/** A distance of marks such as 1, 2, 5, 10 … frames, so that there are about a dozen. */
export function markStep(length: number): number {
  const least = Math.max(1, length / wanted);
  const power = 10 ** Math.floor(Math.log10(least));
  return [1, 2, 5, 10].map((n) => n * power).find((n) => n >= least)!;
}

/** Frames along the timeline; a drag shows them one after the other. */
export function Ruler({ last, length }: { last: number; length: number }) {
  const frame = time.value?.frame ?? 0;
  const step = markStep(length);
  const marks = Array.from({ length: Math.floor(length / step) + 1 }, (_, i) => i * step);
  const onPointerDown = (e: PointerEvent) => {
    const ruler = e.currentTarget as HTMLElement;
    // Not beyond the end, which would make the ruler longer under the pointer.
    const go = (at: PointerEvent) => showFrame(Math.min(last, ((at.clientX - ruler.getBoundingClientRect().left) / ruler.clientWidth) * length));
    ruler.setPointerCapture(e.pointerId);
    ruler.onpointermove = go;
    ruler.onlostpointercapture = () => (ruler.onpointermove = null);
    go(e);
  };
  const onKeyDown = (e: KeyboardEvent) => {
    const last = Math.max(0, (time.value?.frames ?? 1) - 1);
    const to = { ArrowLeft: frame - 1, ArrowRight: frame + 1, PageUp: frame + 10, PageDown: frame - 10, Home: 0, End: last }[e.key];
    if (to === undefined) return;
    showFrame(to);
    e.preventDefault();
    e.stopPropagation();
  };
  return (
    <div
      class="ruler"
      role="slider"
      tabIndex={0}
      aria-label={texts.timeline.ruler}
      aria-valuemin={0}
      aria-valuemax={Math.round(length)}
      aria-valuenow={frame}
      onPointerDown={onPointerDown}
      onKeyDown={onKeyDown}
    >
      {marks.map((m) => <span class="mark" style={{ left: `${(100 * m) / length}%` }} key={m}>{m}</span>)}
    </div>
  );
}
