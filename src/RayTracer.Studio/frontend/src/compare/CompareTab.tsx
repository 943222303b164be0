import { useEffect, useState } from "preact/hooks";
import { get, post } from "../api/client";
import type { PictureComparison, Snapshot } from "../api/types";
import { format } from "../json/numbers";
import type { DockTab } from "../shell/Dock";
import { commandButton } from "../state/commands";
import { attempt, complain } from "../state/messages";
import { compared, comparison, snapshots, type Comparison } from "../state/store";
import { texts } from "../texts";
import { Button } from "../ui/Button";
import { Segments } from "../ui/Segments";
import { Select } from "../ui/Select";
import { TextField } from "../ui/TextField";
import { usePicture } from "../viewport/Overlays";

const t = texts.compare;
const rename = (id: number, name: string | null) => attempt(() => post("view/snapshot/rename", { id, name }));

/** The kept pictures that can be chosen; what they are stands below each. */
const keptChoices = () => (snapshots.value ?? []).map((s) => ({ value: String(s.id), label: s.name }));

const compare = (change: Partial<Comparison>) => (comparison.value = { ...compared.value, ...change });

function Kept({ id, name, samples, time }: Snapshot) {
  const source = usePicture("view/snapshot", { id });
  return (
    <li>
      <span class="kept">{source && <img src={source} alt="" />}</span>
      <TextField label={t.name} value={name} onCommit={(to) => rename(id, to)} />
      <span class="quiet">{t.about(samples, time)}</span>
      <Button label={t.forget(name)} icon="trash" onClick={() => rename(id, null)} />
    </li>
  );
}

/** What the two pictures have to do with one another, in numbers. */
function Numbers({ left, right, shown }: { left: number; right: number; shown: string }) {
  const [found, setFound] = useState<PictureComparison | null>(null);
  useEffect(() => {
    setFound(null);
    get<PictureComparison>("view/compare", { image: left, reference: right }).then(setFound, complain);
  }, [left, right]);
  if (!found) return <p class="quiet" role="status">{t.comparing}</p>;
  return (
    <div role="status">
      <p class="figures">RMSE {format(found.rmse, 4)}, FLIP {format(found.flip, 4)}</p>
      {shown === "difference" && <p class="quiet">{t.differenceWhy(format(found.largestDifference, 4), found.largestX, found.largestY)}</p>}
      {shown === "flip" && <p class="quiet">{t.flipWhy}</p>}
    </div>
  );
}

/** The kept pictures as a strip, and two of them beside each other. */
function CompareTab() {
  const kept = snapshots.value ?? [];
  const { left, right, shown } = compared.value;
  const select = (label: string, value: number | null, none: string, onChange: (id: number | null) => void) => (
    <label class="pair">
      <span>{label}</span>
      <Select label={label} tip={texts.viewport.compareWhy} value={String(value ?? "")} choices={[{ value: "", label: none }, ...keptChoices()]} onChange={(id) => onChange(id ? Number(id) : null)} />
    </label>
  );
  return (
    <div class="compare">
      <div class="pad">
        <Button {...commandButton("snapshot")} showLabel kind="plain" />
        {kept.length === 0 && <p class="quiet">{t.none}</p>}
        {kept.length > 0 && select(t.left, left, texts.viewport.noCompare, (id) => compare({ left: id }))}
        {left !== null && select(t.right, right, t.now, (id) => compare({ right: id }))}
        {left !== null && right === null && <p class="quiet">{kept.length > 1 ? t.choose : t.two}</p>}
        {left !== null && right !== null && (
          <>
            <Segments label={t.how} value={shown} choices={t.ways} onChange={(way) => compare({ shown: way as Comparison["shown"] })} />
            <Numbers left={left} right={right} shown={shown} />
          </>
        )}
      </div>
      <ul class="strip" aria-label={t.kept}>{kept.map((s) => <Kept {...s} key={s.id} />)}</ul>
    </div>
  );
}

export const tab: DockTab = { id: "compare", order: 3.5, help: "studio#the-picture", component: CompareTab };
