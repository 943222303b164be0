import { commandButton, commandItem, runCommand, type CommandId } from "../state/commands";
import { attempt } from "../state/messages";
import { hidden, isOwnView, viewState } from "../state/store";
import { texts } from "../texts";
import { Button } from "../ui/Button";
import { Menu } from "../ui/Menu";
import { forgetView, showView } from "./camera";

const t = texts.viewport;
const cameraItems: CommandId[] = ["home", "setCamera", "frame", "alongX", "alongMinusX", "alongY", "alongMinusY", "alongZ", "alongMinusZ", "bookmark"];

/** Where the picture is seen from. */
export function CameraMenu() {
  const kept = viewState.value?.bookmarks ?? [];
  const items = [
    ...cameraItems.map(commandItem),
    ...kept.map(({ id, name }) => ({ label: name, group: t.bookmarks, run: () => attempt(() => showView(id)) })),
    ...kept.map(({ id, name }) => ({ label: t.forget(name), group: "", run: () => attempt(() => forgetView(id)) })),
  ];
  return <Menu label={t.camera} tip={t.cameraWhy} icon="camera" showLabel={false} items={items} />;
}

/** Says that what is seen is not what files show, and what can be done about that. */
export function OwnView() {
  const count = hidden.value?.length ?? 0;
  if (!isOwnView() && count === 0) return null;
  const button = (id: "home" | "setCamera" | "showAll", label: string) => (
    <Button label={label} tip={commandButton(id).tip} keys={commandButton(id).keys} showLabel kind="plain" onClick={() => runCommand(id)} />
  );
  return (
    <div class="chip own-view" role="group" aria-label={t.ownView} data-handle="own-view">
      {isOwnView() && (
        <>
          <span>{t.ownView}</span>
          {button("home", t.lookThrough)}
          {button("setCamera", t.setCamera)}
        </>
      )}
      {count > 0 && (
        <>
          <span>{t.hidden(count)}</span>
          {button("showAll", texts.commands.showAll[0])}
        </>
      )}
    </div>
  );
}
