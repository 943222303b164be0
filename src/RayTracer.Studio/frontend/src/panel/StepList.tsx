import { join } from "../json/pointer";
import { remove, setValue } from "../state/edits";
import { schema } from "../state/store";
import { texts } from "../texts";
import { Button } from "../ui/Button";
import type { FieldProps } from "./FieldContext";
import { RecordEditor } from "./RecordEditor";
import { sectionOf, spaced, type JsonObject } from "./types";

/** A list of records, such as the steps of a transform. */
export function StepList({ parameter, pointer, value, id }: FieldProps) {
  const type = schema.value && sectionOf(schema.value, parameter);
  if (!type) return null;
  const steps = Array.isArray(value) ? value : [];
  const fresh: JsonObject = {};
  for (const p of type.parameters) if (p.required) fresh[p.key] = p.default ?? 0;
  const add = () => (steps.length ? setValue(join(pointer, steps.length), fresh) : setValue(pointer, [fresh]));
  return (
    <div class="nested" id={id} role="group" aria-label={parameter.key}>
      {steps.map((step, i) => (
        <details open={steps.length < 4} key={i}>
          <summary>{texts.panel.step(i + 1)}</summary>
          <Button label={texts.panel.removeStep(i + 1)} icon="trash" onClick={() => remove([join(pointer, i)])} />
          <RecordEditor type={type} pointer={join(pointer, i)} value={step} />
        </details>
      ))}
      <Button label={texts.panel.addStep(spaced(parameter.key))} icon="add" showLabel kind="plain" onClick={add} />
    </div>
  );
}
