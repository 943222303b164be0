import type { Vec3 } from "../api/types";
import { setValue } from "../state/edits";
import { schema } from "../state/store";
import { texts } from "../texts";
import { Button } from "../ui/Button";
import { NumberField } from "../ui/NumberField";
import { Select } from "../ui/Select";
import { TextField } from "../ui/TextField";
import { showInSource } from "../editor/show";
import { ColorField } from "./ColorField";
import type { FieldProps } from "./FieldContext";
import { FileField } from "./FileField";
import { MaterialField } from "./MaterialField";
import { NumberRow } from "./NumberRow";
import { StepList } from "./StepList";
import { TextureField } from "./TextureField";
import { RecordEditor } from "./RecordEditor";
import { boundsOf, kindOf, sectionOf, spaced } from "./types";

/** The editor for one parameter, by its kind. */
export function Field(props: FieldProps) {
  const { parameter, pointer, value, effective, label, id } = props;
  switch (kindOf(parameter)) {
    case "number":
    case "integer":
      return <NumberRow {...props} />;
    case "boolean":
      return (
        <label class="check">
          <input id={id} type="checkbox" aria-label={label} checked={effective === true} onChange={(e) => setValue(pointer, e.currentTarget.checked)} />
          <span aria-hidden="true">{effective ? texts.panel.on : texts.panel.off}</span>
        </label>
      );
    case "choice": {
      const unset = effective === null ? [{ value: "", label: texts.panel.noneYet }] : [];
      const choices = [...unset, ...parameter.choices.map((c) => ({ value: c, label: spaced(c) }))];
      const word = String(effective ?? "");
      const chosen = parameter.choices.find((c) => c.toLowerCase() === word.toLowerCase()) ?? word;
      return <Select id={id} label={label} value={chosen} choices={choices} onChange={(c) => c && setValue(pointer, c)} />;
    }
    case "text":
      return <TextField id={id} label={label} value={String(effective ?? "")} placeholder={texts.panel.noneYet} onCommit={(t) => setValue(pointer, t)} />;
    case "file":
      return <FileField {...props} />;
    case "vector2":
    case "vector3":
      return <VectorField {...props} />;
    case "color":
      return <ColorField {...props} />;
    case "texture":
      return <TextureField {...props} />;
    case "material":
      return <MaterialField {...props} />;
    case "record": {
      const type = schema.value && sectionOf(schema.value, parameter);
      if (parameter.default === null && value === undefined) return <Button label={texts.panel.set} showLabel kind="plain" onClick={() => setValue(pointer, {})} />;
      return type ? <RecordEditor type={type} pointer={pointer} value={value} /> : null;
    }
    case "records":
      return <StepList {...props} />;
    case "shape":
      if (typeof effective === "string") return <TextField id={id} label={label} value={effective} onCommit={(t) => setValue(pointer, t)} />;
      return <InSource {...props} />;
    default:
      return <InSource {...props} />;
  }
}

function VectorField({ parameter, pointer, effective, label, id }: FieldProps) {
  const count = kindOf(parameter) === "vector3" ? 3 : 2;
  const names = count === 3 ? texts.panel.axes : texts.panel.pair;
  const numbers = Array.isArray(effective) ? (effective as number[]) : null;
  if (!numbers) return <Button label={texts.panel.set} showLabel kind="plain" onClick={() => setValue(pointer, count === 3 ? [0, 0, 0] : [1, 1])} />;
  const change = (i: number, value: number, gesture: string) => setValue(pointer, numbers.map((n, j) => (j === i ? value : n)) as Vec3, gesture);
  return (
    <div class="numbers">
      {numbers.map((n, i) => (
        <NumberField
          id={i === 0 ? id : undefined}
          label={`${label} ${names[i]}`}
          mark={count === 3 ? names[i] : undefined}
          value={n}
          bounds={boundsOf(parameter)}
          onChange={(v, g) => change(i, v, g)}
        />
      ))}
    </div>
  );
}

/** Long lists are better edited as text. */
function InSource({ pointer, value, id }: FieldProps) {
  if (value === undefined) return <span class="quiet" id={id}>{texts.panel.noneYet}</span>;
  return <Button label={texts.panel.show} tip={texts.panel.inText} icon="code" showLabel kind="plain" onClick={() => showInSource(pointer)} />;
}
