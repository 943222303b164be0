import { signal } from "@preact/signals";
import { get } from "../api/client";
import type { ReportTime } from "../api/types";
import { duration, format } from "../json/numbers";
import { attempt } from "../state/messages";
import { fill, texts } from "../texts";
import { Button } from "../ui/Button";
import type { DockTab } from "../shell/Dock";

const t = texts.times;
const times = signal<ReportTime[] | null>(null);
const isMeasuring = signal(false);

const measure = () =>
  attempt(async () => {
    isMeasuring.value = true;
    try {
      times.value = (await get<{ times: ReportTime[] }>("times")).times;
    } finally {
      isMeasuring.value = false;
    }
  });

/** The report's times beside this machine's, which are measured when they are asked for. */
function TimesTab() {
  return (
    <div class="times">
      <p class="pad quiet">{t.explain}</p>
      {!times.value && (
        <div class="pad">
          <Button label={isMeasuring.value ? t.running : t.run} showLabel kind="plain" disabled={isMeasuring.value} onClick={measure} />
        </div>
      )}
      {times.value && (
        <table>
          <caption>{t.label}</caption>
          <thead>
            <tr><th scope="col">{t.figure}</th><th scope="col">{t.settings}</th><th scope="col">{t.report}</th><th scope="col">{t.here}</th><th scope="col">{t.ratio}</th></tr>
          </thead>
          <tbody>
            {times.value.map((row) => (
              <tr key={row.figure}>
                <td>{row.figure}</td>
                <td>{fill(t.setting, { size: row.width, samples: row.samples })}</td>
                <td>{duration(row.reportSeconds)}</td>
                <td>{row.seconds < 1 ? fill(t.milliseconds, { n: format(row.seconds * 1000, 3) }) : duration(row.seconds)}</td>
                <td>{fill(t.times, { n: format(row.reportSeconds / row.seconds, 3) })}</td>
              </tr>
            ))}
          </tbody>
        </table>
      )}
    </div>
  );
}

export const tab: DockTab = { id: "times", order: 5, help: "how-fast-is-it", component: TimesTab };
