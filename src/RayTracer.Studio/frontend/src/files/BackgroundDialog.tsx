import { useState } from "preact/hooks";
import { backgroundKind, dialog, studio, time } from "../state/store";
import { texts } from "../texts";
import { Button } from "../ui/Button";
import { DialogBox } from "../ui/DialogBox";
import { NumberField } from "../ui/NumberField";
import { Segments } from "../ui/Segments";
import { Select } from "../ui/Select";
import { sceneName, startBackground } from "./commands";
import { FileBrowser } from "./FileBrowser";
import { SaveAsDialog, startFolder } from "./FileDialogs";
import { extensionOf, nameOf, withExtension } from "./paths";

const t = texts.background;
const kinds = ["part", "frames", "merge"] as const;
type Kind = (typeof kinds)[number];
const forms = ["png", "animated", "video"] as const;
type Form = (typeof forms)[number];
const emptyFrames = 24;

interface CountProps {
  label: string;
  value: number;
  least: number;
  onChange: (value: number) => void;
}

function Count({ label, value, least, onChange }: CountProps) {
  return (
    <label class="line">
      <span>{label}</span>
      <NumberField label={label} value={value} bounds={{ minimum: least, maximum: null, isInteger: true }} onChange={onChange} />
    </label>
  );
}

interface FilmsProps {
  films: string[];
  onChange: (films: string[]) => void;
}

/** Chooses several films. */
function Films({ films, onChange }: FilmsProps) {
  const pick = (path: string) => extensionOf(path) === "rtfilm" && !films.includes(path) && onChange([...films, path]);
  return (
    <>
      <FileBrowser start={startFolder()} onFolder={() => undefined} onPick={pick} onChoose={pick} picked={films[films.length - 1] ?? ""} />
      <ul aria-label={t.films} class="chosen">
        {films.map((path) => (
          <li key={path}>
            {nameOf(path)}
            <Button label={t.remove(nameOf(path))} icon="close" onClick={() => onChange(films.filter((f) => f !== path))} />
          </li>
        ))}
        {films.length === 0 && <li class="quiet">{t.none}</li>}
      </ul>
    </>
  );
}

/** What to render into files, then where to. */
export function BackgroundDialog() {
  const [kind, setKind] = useState<Kind>(backgroundKind.value);
  const [number, setNumber] = useState(1);
  const [count, setCount] = useState(2);
  const [first, setFirst] = useState(0);
  const [last, setLast] = useState(Math.max(0, (time.value?.frames || emptyFrames) - 1));
  const [form, setForm] = useState<Form>("png");
  const hasVideo = studio.value?.time.hasVideo ?? false;
  const [films, setFilms] = useState<string[]>([]);
  const [isNaming, setNaming] = useState(false);
  const close = () => (dialog.value = null);
  const base = nameOf(withExtension(sceneName(), "x")).slice(0, -2);
  const about = {
    part: { why: t.partWhy, name: `${base}-${number}-of-${count}.rtfilm`, request: { number, count } },
    frames: { why: t.framesWhy, name: `${base}${{ png: "-####.png", animated: ".apng", video: ".mp4" }[form]}`, request: { first, last } },
    merge: { why: t.mergeWhy, name: `${base}.rtfilm`, request: { parts: films } },
  }[kind];

  if (isNaming) return <SaveAsDialog title={t.title} fileName={about.name} onClose={close} onSave={(path) => startBackground(kind, path, about.request)} />;

  const buttons = (
    <>
      <Button label={texts.dialogs.cancel} showLabel kind="plain" onClick={close} />
      <Button label={t.choose} showLabel kind="primary" disabled={(kind === "merge" && films.length === 0) || (kind === "frames" && form === "video" && !hasVideo)} onClick={() => setNaming(true)} />
    </>
  );
  return (
    <DialogBox title={t.title} onClose={close} buttons={buttons} wide={kind === "merge"} help="studio#rendering-to-files-while-you-work">
      <Segments label={t.what} value={kind} choices={kinds.map((k) => ({ value: k, label: t[k] }))} onChange={(k) => setKind(k as Kind)} />
      <p class="quiet">{about.why}</p>
      {kind === "part" && (
        <>
          <Count label={t.number} value={number} least={1} onChange={setNumber} />
          <Count label={t.count} value={count} least={1} onChange={setCount} />
        </>
      )}
      {kind === "frames" && (
        <>
          <Count label={t.first} value={first} least={0} onChange={setFirst} />
          <Count label={t.last} value={last} least={0} onChange={setLast} />
          <label class="line">
            <span>{t.as}</span>
            <Select label={t.as} value={form} choices={forms.map((f) => ({ value: f, label: t[f] }))} onChange={(f) => setForm(f as Form)} />
          </label>
          {form === "video" && !hasVideo && <p class="warning">{t.noVideo}</p>}
        </>
      )}
      {kind === "merge" && <Films films={films} onChange={setFilms} />}
    </DialogBox>
  );
}
