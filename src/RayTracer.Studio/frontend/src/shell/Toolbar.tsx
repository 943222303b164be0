import { addItems } from "../files/add";
import { commandButton, commandItem, type CommandId } from "../state/commands";
import { bottomOpen, leftOpen, rightOpen } from "../state/settings";
import { documentState, renderState } from "../state/store";
import { texts } from "../texts";
import { Button } from "../ui/Button";
import { Menu } from "../ui/Menu";

const t = texts.toolbar;
const fileItems: CommandId[] = ["new", "open", "gallery", "save", "saveAs", "export", "background", "lights", "copyImage", "copyCommand", "bundle"];
const moreItems: CommandId[] = ["duplicate", "delete", "rename", "apply", "hide", "showAll", "lock", "deselect", "filter", "home", "alone", "theme"];
const helpItems: CommandId[] = ["help", "lessons", "shortcuts", "tour"];

const families = ["shape", "light", "environment", "material", "texture"];

/** The row at the top: files, history, rendering, panes. */
export function Toolbar() {
  const doc = documentState.value;
  const isRendering = renderState.value?.status === "rendering";
  const stateOf = (label: string | null | undefined) => (label ? ` (${label})` : "");
  const undo = commandButton("undo");
  const redo = commandButton("redo");
  const pause = commandButton("pause");
  return (
    <header class="toolbar">
     <div class="tools" role="toolbar" aria-label={t.label}>
      <div class="group">
        <Menu label={t.file} items={fileItems.map(commandItem)} />
        <Menu label={t.add} tip={t.addWhy} icon="add" items={families.map((family) => ({ label: texts.families[family]!, items: addItems(family) }))} />
      </div>
      <div class="group">
        <Button {...commandButton("save")} />
        <Button {...undo} tip={`${undo.tip}${stateOf(doc?.undoLabel)}`} />
        <Button {...redo} tip={`${redo.tip}${stateOf(doc?.redoLabel)}`} />
      </div>
      <div class="group">
        <Button {...pause} icon={isRendering ? "pause" : "play"} />
        <Button {...commandButton("stop")} />
        <Button {...commandButton("restart")} />
        <Button {...commandButton("export")} />
      </div>
      <h1 class="title" data-tip={doc?.path ?? undefined}>
        {doc?.isDirty && <span class="dirty" role="img" aria-label={texts.status.unsaved}>•</span>}
        {doc?.name || texts.untitled}
      </h1>
      <div class="group">
        <Button {...commandButton("showScene")} pressed={leftOpen.value} />
        <Button {...commandButton("showDock")} pressed={bottomOpen.value} />
        <Button {...commandButton("showPanel")} pressed={rightOpen.value} />
        <Menu label={t.more} icon="more" showLabel={false} items={moreItems.map(commandItem)} />
        <Menu label={texts.groups.help} icon="help" showLabel={false} items={helpItems.map(commandItem)} />
      </div>
     </div>
    </header>
  );
}
