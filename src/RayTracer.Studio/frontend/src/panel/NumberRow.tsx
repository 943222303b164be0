import { useRef } from "preact/hooks";
import { newGesture, setValue } from "../state/edits";
import { schema } from "../state/store";
import { texts } from "../texts";
import { Button } from "../ui/Button";
import { NumberField } from "../ui/NumberField";
import { Select } from "../ui/Select";
import type { FieldProps } from "./FieldContext";
import { boundsOf, hasSlider, kindOf } from "./types";

/** A number, with a slider where its range is small, and the report's substances where it is a refractive index. */
export function NumberRow({ parameter, pointer, effective, label, id }: FieldProps) {
  const gesture = useRef("");
  if (typeof effective !== "number") {
    return <Button label={texts.panel.set} showLabel kind="plain" onClick={() => setValue(pointer, parameter.minimum ?? 0)} />;
  }
  const bounds = boundsOf(parameter);
  const field = <NumberField id={id} label={label} value={effective} bounds={bounds} onChange={(v, g) => setValue(pointer, v, g)} />;
  if (parameter.key === "refractiveIndex") {
    return (
      <div class="pair">
        {field}
        <Substances value={effective} onChange={(v) => setValue(pointer, v)} />
      </div>
    );
  }
  if (!hasSlider(parameter)) return field;
  return (
    <div class="pair">
      {field}
      <input
        type="range"
        aria-label={texts.panel.slider(label)}
        min={bounds.minimum!}
        max={bounds.maximum!}
        step={kindOf(parameter) === "integer" ? 1 : (bounds.maximum! - bounds.minimum!) / 200}
        value={effective}
        onPointerDown={() => (gesture.current = newGesture())}
        onKeyDown={() => (gesture.current ||= newGesture())}
        onInput={(e) => setValue(pointer, Number(Number(e.currentTarget.value).toPrecision(4)), gesture.current || newGesture())}
      />
    </div>
  );
}

function Substances({ value, onChange }: { value: number; onChange: (value: number) => void }) {
  const substances = schema.value?.refractiveIndices ?? [];
  const found = substances.find((s) => Math.abs(s.value - value) < 1e-6);
  const choices = [{ value: "", label: texts.panel.own }, ...substances.map((s) => ({ value: s.name, label: `${s.name} (${s.value})` }))];
  const choose = (name: string) => {
    const chosen = substances.find((s) => s.name === name);
    if (chosen) onChange(chosen.value);
  };
  return <Select label={texts.panel.refractiveIndex} value={found?.name ?? ""} choices={choices} onChange={choose} />;
}
