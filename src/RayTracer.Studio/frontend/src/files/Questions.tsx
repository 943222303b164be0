import { useState } from "preact/hooks";
import { last } from "../json/pointer";
import { rename } from "../state/edits";
import { attempt } from "../state/messages";
import { dialog, documentState, outline, selection } from "../state/store";
import { findNode } from "../outliner/find";
import { texts } from "../texts";
import { Button } from "../ui/Button";
import { DialogBox } from "../ui/DialogBox";
import { overwriteQuestion, saveScene, unsavedQuestion } from "./commands";

const t = texts.dialogs;

/** Save, lose or keep: asked before something else is opened. */
export function UnsavedQuestion() {
  const question = unsavedQuestion.value;
  if (!question) return null;
  const close = () => (unsavedQuestion.value = null);
  const save = () => {
    close();
    saveScene(question.go);
  };
  const buttons = (
    <>
      <Button label={t.cancel} showLabel kind="plain" onClick={close} />
      <Button label={t.discard} showLabel kind="plain" onClick={() => (close(), attempt(question.go))} />
      <Button label={t.save} showLabel kind="primary" onClick={save} />
    </>
  );
  return (
    <DialogBox title={t.unsavedTitle} onClose={close} buttons={buttons}>
      <p>{t.unsaved(documentState.value?.name || texts.untitled)}</p>
    </DialogBox>
  );
}

export function OverwriteQuestion() {
  const question = overwriteQuestion.value;
  if (!question) return null;
  const close = () => (overwriteQuestion.value = null);
  const buttons = (
    <>
      <Button label={t.cancel} showLabel kind="plain" onClick={close} />
      <Button label={t.replace} showLabel kind="primary" onClick={() => (close(), attempt(question.go))} />
    </>
  );
  return (
    <DialogBox title={t.overwriteTitle} onClose={close} buttons={buttons}>
      <p>{question.why}</p>
    </DialogBox>
  );
}

export function RenameDialog() {
  const pointer = selection.value ?? "";
  const [name, setName] = useState(findNode(outline.value, pointer)?.name ?? last(pointer));
  const close = () => (dialog.value = null);
  const done = () => {
    if (!name.trim()) return;
    close();
    rename(pointer, name.trim());
  };
  const buttons = (
    <>
      <Button label={t.cancel} showLabel kind="plain" onClick={close} />
      <Button label={t.ok} showLabel kind="primary" disabled={!name.trim()} onClick={done} />
    </>
  );
  return (
    <DialogBox title={t.renameTitle} onClose={close} buttons={buttons}>
      <label class="line">
        <span>{t.newName}</span>
        <input type="text" class="text" data-first value={name} onInput={(e) => setName(e.currentTarget.value)} onKeyDown={(e) => e.key === "Enter" && done()} />
      </label>
    </DialogBox>
  );
}
