import { useRef } from "preact/hooks";
import type { Json, Vec3 } from "../api/types";
import { asColor, fromHex, isHex, toHex } from "../json/color";
import { newGesture, setValue } from "../state/edits";
import { schema } from "../state/store";
import { texts } from "../texts";
import { Button } from "../ui/Button";
import { NumberField } from "../ui/NumberField";
import { TextField } from "../ui/TextField";
import type { FieldProps } from "./FieldContext";
import { boundsOf } from "./types";

/** A colour: the browser's picker, a name or #rrggbb, and the linear numbers that the renderer calculates with. */
export function ColorField({ parameter, pointer, value, effective, label, id }: FieldProps) {
  const gesture = useRef("");
  if (effective === null) {
    const start = Math.max(parameter.minimum ?? 0, Math.min(0.5, parameter.maximum ?? 1));
    return <Button label={texts.panel.set} showLabel kind="plain" onClick={() => setValue(pointer, [start, start, start])} />;
  }
  const names = schema.value?.colors ?? {};
  const linear: Vec3 = asColor(effective, names) ?? [0.5, 0.5, 0.5];
  const written = typeof value === "string" ? value : "";

  // Numbers stay numbers; else the picker's own notation is the shortest.
  const pick = (hex: string) => setValue(pointer, (Array.isArray(value) ? fromHex(hex) : hex) as Json, gesture.current || newGesture());
  const name = (text: string) => {
    const tidy = text.trim().toLowerCase();
    if (isHex(tidy) || names[tidy]) setValue(pointer, tidy);
  };
  const change = (i: number, v: number, g: string) => setValue(pointer, linear.map((c, j) => (j === i ? v : c)) as Vec3, g);

  return (
    <div class="color">
      <div class="pair">
        <input
          id={id}
          type="color"
          aria-label={texts.panel.color(label)}
          value={toHex(linear)}
          onFocus={() => (gesture.current = newGesture())}
          onInput={(e) => pick(e.currentTarget.value)}
          onChange={() => (gesture.current = newGesture())}
        />
        <TextField label={texts.panel.colorName(label)} tip={texts.panel.linear} value={written} placeholder={toHex(linear)} list="color-names" onCommit={name} />
      </div>
      <div class="numbers">
        {linear.map((c, i) => (
          <NumberField
            label={`${label} ${texts.panel.channels[i]}`}
            mark={texts.panel.channels[i]!.charAt(0)}
            value={c}
            bounds={boundsOf(parameter)}
            onChange={(v, g) => change(i, v, g)}
          />
        ))}
      </div>
    </div>
  );
}

/** The names that the colour fields offer; once in the window. */
export function ColorNames() {
  return (
    <datalist id="color-names">
      {Object.keys(schema.value?.colors ?? {}).map((name) => <option value={name} />)}
    </datalist>
  );
}
