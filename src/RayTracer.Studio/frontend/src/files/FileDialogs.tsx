import { useState } from "preact/hooks";
import { documentState, dialog } from "../state/store";
import { texts } from "../texts";
import { Button } from "../ui/Button";
import { DialogBox } from "../ui/DialogBox";
import { fileWanted } from "./choose";
import { afterSaving, openScene, sceneName, saveSceneAs } from "./commands";
import { FileBrowser } from "./FileBrowser";
import { extensionOf, folderOf, joinPath, nameOf, withExtension } from "./paths";

const t = texts.dialogs;
export const startFolder = () => {
  const path = documentState.value?.path;
  return path ? folderOf(path) : undefined;
};

interface ChooseProps {
  title: string;
  onClose: () => void;
  onChoose: (path: string) => void;
  named?: boolean;
}

function ChooseDialog({ title, onClose, onChoose, named }: ChooseProps) {
  const [picked, setPicked] = useState("");
  const choose = (path: string) => {
    if (!path) return;
    onClose();
    onChoose(path);
  };
  const buttons = (
    <>
      <Button label={t.cancel} showLabel kind="plain" onClick={onClose} />
      <Button label={t.open} showLabel kind="primary" disabled={!picked} onClick={() => choose(picked)} />
    </>
  );
  return (
    <DialogBox title={title} onClose={onClose} buttons={buttons} wide help="studio#save">
      <FileBrowser start={startFolder()} onFolder={() => setPicked("")} onPick={setPicked} onChoose={choose} picked={picked} named={named} />
    </DialogBox>
  );
}

export const OpenDialog = () => (
  <ChooseDialog title={t.openTitle} onClose={() => (dialog.value = null)} onChoose={(path) => openScene({ path })} />
);

export function WantedFileDialog() {
  const then = fileWanted.value;
  return then && <ChooseDialog title={t.chooseTitle} onClose={() => (fileWanted.value = null)} onChoose={then} named />;
}

interface SaveAsProps {
  title: string;
  fileName: string;
  onClose: () => void;
  onSave: (path: string) => void;
}

/** Asks where to write a file. */
export function SaveAsDialog({ title, fileName, onClose, onSave }: SaveAsProps) {
  const [folder, setFolder] = useState("");
  const [name, setName] = useState(fileName);
  const save = () => {
    if (!folder || !name.trim()) return;
    onClose();
    onSave(joinPath(folder, extensionOf(name) ? name.trim() : withExtension(name.trim(), extensionOf(fileName))));
  };
  const buttons = (
    <>
      <Button label={t.cancel} showLabel kind="plain" onClick={onClose} />
      <Button label={t.save} showLabel kind="primary" disabled={!name.trim()} onClick={save} />
    </>
  );
  return (
    <DialogBox title={title} onClose={onClose} buttons={buttons} wide help="studio#save">
      <FileBrowser start={startFolder()} onFolder={setFolder} onPick={(path) => setName(nameOf(path))} onChoose={(path) => setName(nameOf(path))} picked="" />
      <label class="line">
        <span>{t.fileName}</span>
        <input type="text" class="text" data-first value={name} spellcheck={false} onInput={(e) => setName(e.currentTarget.value)} onKeyDown={(e) => e.key === "Enter" && save()} />
      </label>
    </DialogBox>
  );
}

export function SaveSceneDialog() {
  const then = afterSaving.value;
  const close = () => {
    dialog.value = null;
    afterSaving.value = undefined;
  };
  return <SaveAsDialog title={t.saveTitle} fileName={nameOf(withExtension(sceneName(), "json"))} onClose={close} onSave={(path) => saveSceneAs(path, then)} />;
}
