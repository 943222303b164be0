import { useMemo, useState } from "preact/hooks";
import { post } from "../api/client";
import { Latest } from "../api/latest";
import type { Vec3 } from "../api/types";
import { Light } from "../files/LightsDialog";
import type { DockTab } from "../shell/Dock";
import { findNode } from "../outliner/find";
import { attempt, complain } from "../state/messages";
import { mixedLights, outline } from "../state/store";
import { texts } from "../texts";
import { Button } from "../ui/Button";

const t = texts.lights;
type Factors = Record<string, Vec3>;
const mix = (factors: Factors | null) => post("view/lights/mix", { factors });

// As the outliner has them: layers are named by letters that all programs know.
const shownName = (layer: string, pointers: string[]) =>
  pointers.map((p) => findNode(outline.value, p)?.name ?? layer).join(", ") || (surroundings[layer] ?? layer);
const { background, environment, ambient } = texts.outliner;
const surroundings: Record<string, string> = { background, environment, ambient };

/** The lights of the picture that is being rendered, to be balanced at once. */
function LightsTab() {
  const [own, setOwn] = useState<Factors>({});
  const asking = useMemo(() => new Latest(mix, complain), []);
  const lights = mixedLights.value;
  if (!lights) {
    return (
      <div class="mixer pad">
        <p class="quiet">{t.mixWhy}</p>
        <Button label={t.mix} showLabel kind="primary" onClick={() => attempt(() => mix({}))} />
      </div>
    );
  }
  const factors = Object.fromEntries(lights.map(({ name, factor }) => [name, own[name] ?? factor]));
  const set = (now: Factors) => {
    setOwn(now);
    asking.push(now);
  };
  const isPlain = Object.values(factors).every((f) => f.every((x) => x === 1));
  const finish = (work: () => Promise<unknown>) => attempt(async () => {
    await asking.settled();
    await work();
    setOwn({});
  });
  return (
    <div class="mixer pad">
      {lights.length === 0 && <p class="quiet">{t.none}</p>}
      {lights.map(({ name, pointers }) => <Light key={name} name={shownName(name, pointers)} factor={factors[name]!} onChange={(factor) => set({ ...factors, [name]: factor })} />)}
      <div class="group">
        <Button label={t.intoScene} tip={t.intoSceneWhy} showLabel kind="primary" disabled={isPlain} onClick={() => finish(() => post("view/lights/write"))} />
        <Button label={t.reset} showLabel kind="plain" disabled={isPlain} onClick={() => finish(() => mix({}))} />
        <Button label={t.end} showLabel kind="plain" onClick={() => finish(() => mix(null))} />
      </div>
    </div>
  );
}

export const tab: DockTab = { id: "lights", order: 2.5, help: "studio#lights-after-rendering", component: LightsTab };
