import uPlot from "uplot";
import "uplot/dist/uPlot.min.css";
import { useEffect, useRef } from "preact/hooks";
import type { Convergence } from "../api/types";
import { format } from "../json/numbers";
import { isDark } from "../state/settings";
import { texts } from "../texts";
import { theoryLine } from "./theory";

const t = texts.convergence;

function options(width: number, height: number, dark: boolean): uPlot.Options {
  const [text, line, accent, theory] = dark ? ["#b7c1cb", "#3a444e", "#6fb0f0", "#ffb45c"] : ["#4a5663", "#d9dfe5", "#2468b0", "#b86200"];
  const axis = (label: string): uPlot.Axis => ({
    label, stroke: text!, labelSize: 22, font: "11px system-ui", labelFont: "12px system-ui",
    grid: { stroke: line!, width: 1 }, ticks: { stroke: line!, width: 1 },
    values: (_, splits) => splits.map((v) => (v === null ? "" : format(v, 2))),
  });
  return {
    width, height,
    scales: { x: { time: false, distr: 3 }, y: { distr: 3 } },
    axes: [{ ...axis(t.samples), size: 32 }, { ...axis(t.rmse), size: 64 }],
    series: [
      { label: t.samples },
      { label: t.error, stroke: accent!, width: 2, points: { show: true, size: 6 } },
      { label: t.theory, stroke: theory!, width: 1.5, dash: [6, 4], points: { show: false } },
    ],
    cursor: { y: false },
    legend: { live: false },
  };
}

/** Error against samples, both axes logarithmic, beside the theory's slope. */
export default function ConvergencePlot({ points }: Pick<Convergence, "points">) {
  const ref = useRef<HTMLDivElement>(null);
  const plot = useRef<uPlot | null>(null);
  const data = useRef<uPlot.AlignedData>([[], [], []]);
  const dark = isDark();
  data.current = [points.map((p) => p.samples), points.map((p) => p.error), theoryLine(points)];

  useEffect(() => {
    const box = ref.current!;
    const size = () => ({ width: Math.max(240, box.clientWidth), height: Math.max(120, box.clientHeight - 32) });
    const { width, height } = size();
    plot.current = new uPlot(options(width, height, dark), data.current, box);
    const watcher = new ResizeObserver(() => plot.current?.setSize(size()));
    watcher.observe(box);
    return () => {
      watcher.disconnect();
      plot.current?.destroy();
    };
  }, [dark]);
  useEffect(() => plot.current?.setData(data.current), [points]);
  return <div class="plot" ref={ref} role="img" aria-label={`${texts.convergence.label}: ${points.map((p) => `${p.samples}: ${format(p.error, 3)}`).join("; ")}`} />;
}
