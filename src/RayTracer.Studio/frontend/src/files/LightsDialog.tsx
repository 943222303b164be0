import { useEffect, useMemo, useState } from "preact/hooks";
import { post } from "../api/client";
import { Latest } from "../api/latest";
import type { Vec3 } from "../api/types";
import { fromHex, toHex } from "../json/color";
import { attempt, complain } from "../state/messages";
import { dialog } from "../state/store";
import { texts } from "../texts";
import { Button } from "../ui/Button";
import { DialogBox } from "../ui/DialogBox";
import { pictureAddress, sceneName, startLights } from "./commands";
import { FileBrowser } from "./FileBrowser";
import { SaveAsDialog, startFolder } from "./FileDialogs";
import { extensionOf, nameOf, withExtension } from "./paths";

const t = texts.lights;
const close = () => (dialog.value = null);
type Factors = Record<string, Vec3>;

interface LightProps {
  name: string;
  factor: Vec3;
  onChange: (factor: Vec3) => void;
}

/** How strong a light is, and of which colour. */
export function Light({ name, factor, onChange }: LightProps) {
  // Of a light that is off, the colour would be lost.
  const [hue, setHue] = useState<Vec3>([1, 1, 1]);
  const strength = Math.max(...factor);
  const color = toHex(strength > 0 ? (factor.map((x) => x / strength) as Vec3) : hue);
  const change = (s: number, c: string) => {
    setHue(fromHex(c) as Vec3);
    onChange(fromHex(c).map((x) => x * s) as Vec3);
  };
  return (
    <div class="light">
      <span>{name}</span>
      <input type="range" aria-label={t.strength(name)} min={0} max={4} step={0.05} value={strength} onInput={(e) => change(Number(e.currentTarget.value), color)} />
      <output>{strength.toFixed(2)}</output>
      <input type="color" aria-label={t.color(name)} value={color} onInput={(e) => change(strength, e.currentTarget.value)} />
    </div>
  );
}

/** A picture whose lights are balanced, while its sliders move. */
function Balance({ path, lights }: { path: string; lights: string[] }) {
  const [factors, setFactors] = useState<Factors>({});
  const [source, setSource] = useState("");
  const [isNaming, setNaming] = useState(false);
  const asking = useMemo(() => new Latest(async (f: Factors) => setSource(await pictureAddress("lights/picture", { factors: JSON.stringify(f) })), complain), []);
  useEffect(() => asking.push(factors), [factors]);
  useEffect(() => () => URL.revokeObjectURL(source), [source]);
  if (isNaming) {
    return <SaveAsDialog title={t.title} fileName={`balanced-${nameOf(withExtension(path, "png"))}`} onClose={close} onSave={(to) => startLights("save", to, { factors })} />;
  }
  const buttons = (
    <>
      <Button label={texts.dialogs.cancel} showLabel kind="plain" onClick={close} />
      <Button label={t.write} showLabel kind="primary" onClick={() => setNaming(true)} />
    </>
  );
  return (
    <DialogBox title={t.title} onClose={close} buttons={buttons} wide help="light-layers">
      {source && <img class="balance" src={source} alt={nameOf(path)} />}
      {lights.map((name) => <Light key={name} name={name} factor={factors[name] ?? [1, 1, 1]} onChange={(f) => setFactors((old) => ({ ...old, [name]: f }))} />)}
    </DialogBox>
  );
}

/** Chooses a picture with a layer for each light, or renders one; then balances the lights. */
export function LightsDialog() {
  const [picked, setPicked] = useState("");
  const [lights, setLights] = useState<string[] | null>(null);
  const [isNaming, setNaming] = useState(false);
  if (lights) return <Balance path={picked} lights={lights} />;
  if (isNaming) return <SaveAsDialog title={t.render} fileName={nameOf(withExtension(sceneName(), "exr"))} onClose={close} onSave={(path) => startLights("render", path, {})} />;
  const open = (path: string) => attempt(async () => {
    setPicked(path);
    setLights((await post<{ lights: string[] }>("lights/open", { path })).lights);
  });
  const buttons = (
    <>
      <Button label={texts.dialogs.cancel} showLabel kind="plain" onClick={close} />
      <Button label={t.render} showLabel kind="plain" onClick={() => setNaming(true)} />
      <Button label={texts.dialogs.open} showLabel kind="primary" disabled={extensionOf(picked) !== "exr"} onClick={() => open(picked)} />
    </>
  );
  return (
    <DialogBox title={t.title} onClose={close} buttons={buttons} wide help="light-layers">
      <p class="quiet">{t.why}</p>
      <FileBrowser start={startFolder()} onFolder={() => setPicked("")} onPick={setPicked} onChoose={open} picked={picked} />
    </DialogBox>
  );
}
