import { useEffect, useState } from "preact/hooks";
import { effect } from "@preact/signals";
import { texts } from "../texts";
import { binCount, histogramOf } from "./histogram";
import { paintedFrames, paintedPixels } from "./stage";

const t = texts.viewport;
const pause = 300;
const percent = (share: number) => `${(100 * share).toFixed(share < 0.1 ? 1 : 0)}\u00a0%`;

/** The histogram of what is on the screen; the highest column of the inner ones fills it. */
export function HistogramPlot() {
  const [shown, setShown] = useState(() => histogramOf(paintedPixels.peek()));
  useEffect(() => {
    let timer = 0;
    const stop = effect(() => {
      void paintedFrames.value;
      timer ||= window.setTimeout(() => {
        timer = 0;
        setShown(histogramOf(paintedPixels.peek()));
      }, pause);
    });
    return () => {
      stop();
      clearTimeout(timer);
    };
  }, []);
  const most = Math.max(1, ...shown.channels.flatMap((c) => c.slice(1, -1)));
  const points = (counts: number[]) => `0,100 ${counts.map((n, i) => `${i},${100 - Math.min(100, (100 * n) / most)} ${i + 1},${100 - Math.min(100, (100 * n) / most)}`).join(" ")} ${binCount},100`;
  return (
    <figure class="histogram">
      <svg viewBox={`0 0 ${binCount} 100`} preserveAspectRatio="none" role="img" aria-label={t.histogram}>
        {shown.channels.map((counts, i) => <polygon class={["red", "green", "blue"][i]} points={points(counts)} />)}
      </svg>
      <figcaption class="quiet">{t.clipped(percent(shown.black), percent(shown.white))}</figcaption>
    </figure>
  );
}
