import type { Json, CatalogueType } from "../api/types";
import { join } from "../json/pointer";
import { resetValue } from "../state/edits";
import { outline, time } from "../state/store";
import { texts } from "../texts";
import { Button } from "../ui/Button";
import { animatedAt, atTime } from "../timeline/atTime";
import { canBeAnimated, KeyButton } from "../timeline/KeyButton";
import { Field } from "./Field";
import { asNumber, isObject, kindOf, spaced } from "./types";
import type { CatalogueParameter } from "../api/types";

interface RecordEditorProps {
  type: CatalogueType;
  pointer: string;
  value: Json | undefined;
  /** Parameters that are shown elsewhere. */
  without?: readonly string[];
}

const tallKinds = new Set(["color", "texture", "material", "record", "records", "vector3", "file"]);

const isTall = (parameter: CatalogueParameter, effective: Json) =>
  tallKinds.has(kindOf(parameter)) && !(parameter.isNumber && asNumber(effective) !== null) && !(kindOf(parameter) === "color" && effective === null);

function explain(parameter: CatalogueParameter): string {
  const { range, unit, summary } = parameter;
  return [summary, unit && `(${texts.panel.unit(unit)})`, range && `${texts.panel.range(range)}.`].filter(Boolean).join(" ");
}

/** One row for each parameter of a record, in the schema's order. */
export function RecordEditor({ type, pointer, value, without = [] }: RecordEditorProps) {
  const reasons = outline.value?.idle ?? {};
  const shown = type.parameters.filter((p) => !without.includes(p.key));
  const reasonOf = (parameter: CatalogueParameter) => reasons[join(pointer, parameter.key)];
  const idle = shown.filter(reasonOf);
  return (
    <div class="record">
      <Rows parameters={shown.filter((p) => !reasonOf(p))} pointer={pointer} value={value} />
      {idle.length > 0 && (
        <details class="idle">
          <summary>{texts.panel.idle(idle.map((p) => spaced(p.key)).join(", "))}</summary>
          {idle.map((p, i) => (
            <div key={p.key}>
              {reasonOf(p) !== (i > 0 && reasonOf(idle[i - 1]!)) && <p class="quiet">{reasonOf(p)}</p>}
              <Rows parameters={[p]} pointer={pointer} value={value} />
            </div>
          ))}
        </details>
      )}
    </div>
  );
}

interface RowsProps {
  parameters: readonly CatalogueParameter[];
  pointer: string;
  value: Json | undefined;
}

function Rows({ parameters, pointer, value }: RowsProps) {
  const animated = time.value?.values ?? [];
  const written = isObject(value) ? value : {};
  return (
    <>
      {parameters.map((parameter) => {
        const at = join(pointer, parameter.key);
        const own = written[parameter.key];
        const isAnimated = animatedAt(at, animated).length > 0;
        const effective = atTime(at, own ?? parameter.default, animated) ?? null;
        const id = `field${at.replace(/\W/g, "-")}`;
        const label = spaced(parameter.key);
        return (
          <div class={`row ${isTall(parameter, own ?? parameter.default) ? "tall" : ""} ${own === undefined ? "default" : ""} ${isAnimated ? "animated" : ""}`} key={parameter.key}>
            <div class="row-label" data-tip={explain(parameter)}>
              <label for={id}>{label}</label>
              {parameter.unit && <span class="unit">{parameter.unit}</span>}
              {canBeAnimated(parameter, effective) && <KeyButton pointer={at} label={label} />}
            </div>
            <div class="row-field">
              <Field parameter={parameter} pointer={at} value={isAnimated ? effective : own} effective={effective} label={label} id={id} />
            </div>
            {own !== undefined && !parameter.required ? (
              <Button label={texts.panel.reset(label)} tip={texts.panel.resetWhy} icon="reset" onClick={() => resetValue(at)} />
            ) : (
              <span class="no-reset" />
            )}
          </div>
        );
      })}
    </>
  );
}
