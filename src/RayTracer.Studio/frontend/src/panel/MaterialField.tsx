import { join } from "../json/pointer";
import { select, setValue } from "../state/edits";
import { outline, schema } from "../state/store";
import { texts } from "../texts";
import { Button } from "../ui/Button";
import { Select } from "../ui/Select";
import type { FieldProps } from "./FieldContext";
import { RecordEditor } from "./RecordEditor";
import { findType, isObject, retyped } from "./types";

/** A material: one of the named ones, or one that is written in place. */
export function MaterialField({ pointer, value, label, id }: FieldProps) {
  const known = schema.value;
  if (!known) return null;
  const names = (outline.value?.materials ?? []).map((m) => m.name);
  const types = known.types.material ?? [];
  const chosen = typeof value === "string" ? `name:${value}` : isObject(value) ? `type:${String(value.type)}` : "";
  const choices = [
    ...(chosen === "" ? [{ value: "", label: texts.panel.noneYet }] : []),
    ...names.map((n) => ({ value: `name:${n}`, label: n, group: texts.panel.named })),
    ...types.map((t) => ({ value: `type:${t.name}`, label: t.name, group: texts.panel.inPlace })),
  ];
  const inPlace = isObject(value) ? findType(known, "material", String(value.type)) : null;
  const choose = (choice: string) => {
    const name = choice.slice(5);
    const type = choice.startsWith("type:") ? findType(known, "material", name) : null;
    if (type) setValue(pointer, retyped(value, type, inPlace));
    else if (choice) setValue(pointer, name);
  };
  return (
    <div class="nested">
      <div class="pair">
        <Select id={id} label={label} value={chosen} choices={choices} onChange={choose} />
        {typeof value === "string" && <Button label={texts.panel.edit(value)} icon="sliders" onClick={() => select(join("/materials", value))} />}
      </div>
      {inPlace && <RecordEditor type={inPlace} pointer={pointer} value={value} />}
    </div>
  );
}
