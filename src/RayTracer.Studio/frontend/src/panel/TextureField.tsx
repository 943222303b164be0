import { asColor } from "../json/color";
import { join } from "../json/pointer";
import { select, setValue } from "../state/edits";
import { outline, schema } from "../state/store";
import { texts } from "../texts";
import { Button } from "../ui/Button";
import { Select } from "../ui/Select";
import { ColorField } from "./ColorField";
import type { FieldProps } from "./FieldContext";
import { RecordEditor } from "./RecordEditor";
import { findType, isObject, retyped } from "./types";

const plainColor = "color";

/** A texture: a colour, one of the named ones, or one that is written in place. */
export function TextureField(props: FieldProps) {
  const { pointer, effective, label, id } = props;
  const known = schema.value;
  if (!known) return null;
  const isColor = effective === null || asColor(effective, known.colors) !== null;
  const chosen = isColor ? plainColor : typeof effective === "string" ? `name:${effective}` : isObject(effective) ? `type:${String(effective.type)}` : plainColor;
  const choices = [
    { value: plainColor, label: texts.panel.color(label).split(": ")[1] ?? plainColor },
    ...(outline.value?.textures ?? []).map((t) => ({ value: `name:${t.name}`, label: t.name, group: texts.panel.named })),
    ...(known.types.texture ?? []).map((t) => ({ value: `type:${t.name}`, label: t.name, group: texts.panel.inPlace })),
  ];
  const choose = (choice: string) => {
    const name = choice.slice(5);
    const type = choice.startsWith("type:") ? findType(known, "texture", name) : null;
    if (type) setValue(pointer, retyped(effective, type));
    else setValue(pointer, choice === plainColor ? [0.5, 0.5, 0.5] : name);
  };
  const inPlace = isObject(effective) ? findType(known, "texture", String(effective.type)) : null;
  return (
    <div class="nested">
      <div class="pair">
        <Select id={isColor ? undefined! : id} label={`${label}: ${texts.families.texture}`} value={chosen} choices={choices} onChange={choose} />
        {chosen.startsWith("name:") && <Button label={texts.panel.edit(chosen.slice(5))} icon="sliders" onClick={() => select(join("/textures", chosen.slice(5)))} />}
      </div>
      {isColor && <ColorField {...props} />}
      {inPlace && <RecordEditor type={inPlace} pointer={pointer} value={effective} />}
    </div>
  );
}
