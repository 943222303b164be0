import { asColor } from "../json/color";
import { join } from "../json/pointer";
import { select, setValue } from "../state/edits";
import { outline, schema } from "../state/store";
import { texts } from "../texts";
import { Button } from "../ui/Button";
import { Select } from "../ui/Select";
import { ColorField } from "./ColorField";
import type { FieldProps } from "./FieldContext";
import { NumberRow } from "./NumberRow";
import { RecordEditor } from "./RecordEditor";
import { retype } from "./retype";
import { asNumber, findType, isObject } from "./types";

const plainColor = "color";
const plainNumber = "number";

/** A texture: a colour, or a number where that may stand for one; one of the named ones, or one that is written in place. */
export function TextureField(props: FieldProps) {
  const { parameter, pointer, effective, label, id } = props;
  const known = schema.value;
  if (!known) return null;
  const number = parameter.isNumber ? asNumber(effective) : null;
  const isColor = number === null && asColor(effective, known.colors) !== null;
  const inPlace = isObject(effective) ? findType(known, "texture", String(effective.type)) : null;
  const chosen = number !== null ? plainNumber : isColor ? plainColor : typeof effective === "string" ? `name:${effective}` : inPlace ? `type:${inPlace.name}` : "";
  const choices = [
    ...(chosen === "" ? [{ value: "", label: texts.panel.noneYet }] : []),
    ...(parameter.isNumber ? [{ value: plainNumber, label: texts.panel.number }] : []),
    ...(isColor || !parameter.isNumber ? [{ value: plainColor, label: texts.panel.plainColor }] : []),
    ...(outline.value?.textures ?? []).map((t) => ({ value: `name:${t.name}`, label: t.name, group: texts.panel.named })),
    ...(known.types.texture ?? []).map((t) => ({ value: `type:${t.name}`, label: t.name, group: texts.panel.inPlace })),
  ];
  const choose = (choice: string) => {
    const name = choice.slice(5);
    const type = choice.startsWith("type:") ? findType(known, "texture", name) : null;
    if (type) return retype(pointer, effective, type, inPlace);
    if (choice === plainNumber) setValue(pointer, asNumber(parameter.default) ?? 0.5);
    else if (choice === plainColor) setValue(pointer, [0.5, 0.5, 0.5]);
    else if (choice) setValue(pointer, name);
  };
  const kinds = <Select id={isColor || number !== null ? undefined! : id} label={`${label}: ${texts.families.texture}`} value={chosen} choices={choices} onChange={choose} />;
  if (number !== null) {
    return (
      <div class="number-or">
        <NumberRow {...props} effective={number} />
        {kinds}
      </div>
    );
  }
  return (
    <div class="nested">
      <div class="pair">
        {kinds}
        {chosen.startsWith("name:") && <Button label={texts.panel.edit(chosen.slice(5))} icon="sliders" onClick={() => select(join("/textures", chosen.slice(5)))} />}
      </div>
      {isColor && <ColorField {...props} />}
      {inPlace && <RecordEditor type={inPlace} pointer={pointer} value={effective} />}
    </div>
  );
}
