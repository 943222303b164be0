import { add } from "../files/add";
import { resetValue, setValue } from "../state/edits";
import { schema } from "../state/store";
import { texts } from "../texts";
import { Select } from "../ui/Select";
import { RecordEditor } from "./RecordEditor";
import { findType, isObject, retyped } from "./types";
import { useValue } from "./useValue";

const pointer = "/environment";

/** What surrounds the scene: nothing but its background, or light from all around. */
export function EnvironmentPanel() {
  const known = schema.value;
  const value = useValue(pointer)?.value;
  if (!known) return null;
  const type = isObject(value) ? findType(known, "environment", String(value.type)) : null;
  const choices = [{ value: "", label: texts.panel.noEnvironment }, ...(known.types.environment ?? []).map((t) => ({ value: t.name, label: t.name }))];
  const choose = (name: string) => {
    const chosen = findType(known, "environment", name);
    if (!chosen) resetValue(pointer);
    else if (type && !chosen.parameters.some((p) => p.required)) setValue(pointer, retyped(value, chosen, type));
    else return add("environment", chosen);
    return true;
  };
  return (
    <section aria-label={texts.families.environment}>
      <div class="row">
        <div class="row-label" data-tip={texts.panel.environmentWhy}><label for="environment">{texts.outliner.environment}</label></div>
        <div class="row-field"><Select id="environment" label={texts.families.environment!} value={type?.name ?? ""} choices={choices} onChange={choose} /></div>
        <span class="no-reset" />
      </div>
      {type && <p class="summary" data-tip={type.summary}>{type.summary}</p>}
      {type && <RecordEditor type={type} pointer={pointer} value={value} />}
    </section>
  );
}
