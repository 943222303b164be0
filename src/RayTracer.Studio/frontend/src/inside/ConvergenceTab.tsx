import type { ComponentType } from "preact";
import { useEffect, useState } from "preact/hooks";
import type { Convergence } from "../api/types";
import { format } from "../json/numbers";
import { texts } from "../texts";
import { usePoll } from "./poll";
import type { DockTab } from "../shell/Dock";

const t = texts.convergence;

/** How the error falls; the plot's code is loaded when it is first looked at. */
function ConvergenceTab() {
  const [Plot, setPlot] = useState<ComponentType<Pick<Convergence, "points">> | null>(null);
  useEffect(() => void import("./ConvergencePlot").then((m) => setPlot(() => m.default)), []);
  const answer = usePoll<Convergence>("convergence", 1500);
  const points = (answer?.points ?? []).filter((p) => p.error > 0);
  return (
    <div class="convergence">
      <div class="pad explain">
        <p class="quiet">{t.explain}</p>
        {answer?.slope != null && <p>{t.slope(format(answer.slope, 3))}</p>}
        {points.length < 2 && <p role="status">{t.waiting}</p>}
      </div>
      {Plot && points.length >= 2 && <Plot points={points} />}
    </div>
  );
}

export const tab: DockTab = { id: "convergence", order: 4, help: "studio#look-inside", component: ConvergenceTab };
