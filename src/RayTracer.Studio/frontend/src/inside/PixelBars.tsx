import type { LightShare } from "../api/types";
import { format } from "../json/numbers";
import { texts } from "../texts";
import { drawsAll, litSamples, summary } from "./paths";

const t = texts.paths;
const percent = (share: number) => `${format(100 * share, 3)} %`;

function Bars({ title, shares, names }: { title: string; shares: LightShare[]; names?: Record<string, string> }) {
  const choose = (share: LightShare) => {
    litSamples.value = litSamples.value === share.samples ? null : share.samples;
    drawsAll.value = litSamples.value !== null;
  };
  return (
    <section class="bars">
      <h4>{title}</h4>
      <ul>
        {shares.map((s) => (
          <li key={s.name}>
            <button type="button" class="list-button" aria-pressed={litSamples.value === s.samples} onClick={() => choose(s)}>
              <span class="name">{names?.[s.name] ?? s.name}</span><span class="bar-track"><span style={{ width: `${100 * Math.min(1, s.share)}%` }} /></span>
              <span class="figures">{percent(s.share)}</span>
            </button>
            {names && s.variance > 0.005 && <small class="quiet">{t.ofNoise(percent(s.variance))}</small>}
          </li>
        ))}
      </ul>
    </section>
  );
}

/** Where the light of the pixel comes from, over its samples, and its noise. */
export function PixelBars() {
  const sums = summary.value;
  if (!sums) return <p class="pad" role="status">{t.summing}</p>;
  return (
    <div class="pixel-bars">
      <p><strong>{t.noise(percent(sums.noise), sums.samples)}</strong> {sums.advice}</p>
      <Bars title={t.byLight} shares={sums.lights} />
      <Bars title={t.byTechnique} shares={sums.techniques} names={t.techniques} />
      <Bars title={t.byDepth} shares={sums.depths} />
      <Bars title={t.byThing} shares={sums.things} />
    </div>
  );
}
