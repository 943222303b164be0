import { last } from "../json/pointer";
import { commandButton } from "../state/commands";
import { duplicate, isGiven, isThing, remove, withSelection } from "../state/edits";
import { dialog, schema, selected } from "../state/store";
import { texts } from "../texts";
import { Button } from "../ui/Button";
import { Select } from "../ui/Select";
import { showInSource } from "../editor/show";
import { RecordEditor } from "./RecordEditor";
import { retype } from "./retype";
import { findType, isObject, kindOf } from "./types";
import { useValue } from "./useValue";
import { Field } from "./Field";

/** The properties of one thing: its name, what it is, and a row for each parameter. */
export function ThingPanel({ pointer, without = ["name"] }: { pointer: string; without?: readonly string[] }) {
  const known = schema.value;
  const answer = useValue(pointer);
  if (!known || !answer) return null;
  const type = findType(known, answer.family, answer.type);
  if (!type) return <PlainValue pointer={pointer} answer={answer.value} />;

  const canRetype = answer.family === "material" || answer.family === "texture" || answer.family === "light";
  const ownName = isObject(answer.value) && typeof answer.value.name === "string" ? answer.value.name : null;
  const title = ownName ?? (/^\d+$/.test(last(pointer)) ? type.name : last(pointer));
  const types = known.types[answer.family ?? ""] ?? [];
  const change = (name: string) => {
    const chosen = findType(known, answer.family, name);
    return !chosen || retype(pointer, answer.value, chosen, type, answer.family);
  };
  return (
    <section class="thing" aria-label={title} data-help={`scene-format#${type.name}`}>
      {isThing(pointer) && (
        <header>
          <h2>{title}</h2>
          <Button label={texts.commands.rename[0]} tip={texts.commands.rename[1]} icon="rename" onClick={() => (dialog.value = "rename")} />
          <Button label={texts.commands.duplicate[0]} tip={texts.commands.duplicate[1]} icon="copy" onClick={() => withSelection(duplicate)} />
          <Button label={texts.panel.show} icon="code" onClick={() => showInSource(pointer)} />
          <Button label={texts.commands.delete[0]} tip={texts.commands.delete[1]} icon="trash" onClick={() => withSelection(remove)} />
        </header>
      )}
      {(selected.value?.length ?? 0) > 1 && <p class="summary">{texts.panel.several(selected.value!.length)}</p>}
      {(selected.value?.length ?? 0) > 1 && isGiven(pointer) && <Button {...commandButton("apply")} showLabel kind="plain" />}
      {canRetype ? (
        <div class="row">
          <div class="row-label"><label for="thing-type">{texts.panel.type}</label></div>
          <div class="row-field"><Select id="thing-type" label={texts.panel.type} value={type.name} choices={types.map((t) => ({ value: t.name, label: t.name }))} onChange={change} /></div>
          <span class="no-reset" />
        </div>
      ) : null}
      {type.summary && <p class="summary" data-tip={type.summary}>{type.summary}</p>}
      <RecordEditor type={type} pointer={pointer} value={answer.value} without={without} />
    </section>
  );
}

/** A place that is no record: the background, or a texture that is just a colour. */
function PlainValue({ pointer, answer }: { pointer: string; answer: import("../api/types").Json }) {
  const known = schema.value!;
  const key = last(pointer);
  const parameter = known.sections.scene?.parameters.find((p) => p.key === key)
    ?? known.types.texture?.find((t) => t.name === "solid")?.parameters.find((p) => kindOf(p) === "color");
  if (!parameter) return <p class="quiet">{texts.panel.cannotRead}</p>;
  return (
    <div class="row tall">
      <div class="row-label" data-tip={parameter.summary}><label for="plain-value">{key}</label></div>
      <div class="row-field"><Field parameter={parameter} pointer={pointer} value={answer ?? undefined} effective={answer ?? parameter.default} label={key} id="plain-value" /></div>
      <span class="no-reset" />
    </div>
  );
}
