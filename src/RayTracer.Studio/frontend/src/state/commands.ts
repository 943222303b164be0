/** Everything that a menu, a button or a key can do, once. */

import { post } from "../api/client";
import { flushEditor } from "../editor/flush";
import { copyCommand, copyImage, newScene, saveScene, shareBundle } from "../files/commands";
import { texts } from "../texts";
import type { ButtonProps } from "../ui/Button";
import type { MenuItem } from "../ui/Menu";
import type { IconName } from "../ui/Icon";
import { cameraHome } from "../viewport/camera";
import { actualSize, fit, zoomBy } from "../viewport/stage";
import { askForName, duplicate, remove, select, withSelection } from "./edits";
import { attempt } from "./messages";
import { bottomOpen, bottomTab, leftOpen, leftTab, rightOpen, theme, type Theme } from "./settings";
import { compared, dialog, documentState, renderState, tool, tourStep, type Tool } from "./store";

export type CommandId = keyof typeof texts.commands;
export type Group = keyof typeof texts.groups;

export interface Command {
  group: Group;
  run: () => void;
  icon?: IconName;
  /** As in `KeyboardEvent.key`, with "Mod+", "Shift+" and "Alt+" before it; Mod is Ctrl, or Command on a Mac. */
  keys?: string;
  enabled?: () => boolean;
}

const history = (step: "undo" | "redo") =>
  attempt(async () => {
    await flushEditor();
    await post(`document/${step}`);
  });

const rendering = (action: string) => attempt(() => post("view/render", { action }));
const isRunning = () => renderState.value?.status === "rendering";
const choose = (name: Tool) => () => (tool.value = name);
const toggle = (open: { value: boolean }) => () => (open.value = !open.value);

function showDock(tab: string): void {
  bottomOpen.value = true;
  bottomTab.value = tab;
}

function nextTheme(): void {
  const order: Theme[] = ["system", "light", "dark"];
  theme.value = order[(order.indexOf(theme.value) + 1) % order.length]!;
}

const keepPicture = () =>
  attempt(async () => {
    compared.value = (await post<{ id: number }>("view/snapshot")).id;
  });

export const commands: Record<CommandId, Command> = {
  new: { group: "file", run: newScene, icon: "add", keys: "Alt+n" },
  open: { group: "file", run: () => (dialog.value = "open"), icon: "open", keys: "Mod+o" },
  gallery: { group: "file", run: () => ((leftOpen.value = true), (leftTab.value = "gallery")), icon: "background", keys: "Alt+g" },
  save: { group: "file", run: saveScene, icon: "save", keys: "Mod+s" },
  saveAs: { group: "file", run: () => (dialog.value = "saveAs"), icon: "save", keys: "Mod+Shift+S" },
  export: { group: "file", run: () => (dialog.value = "export"), icon: "export", keys: "Mod+e" },
  copyImage: { group: "file", run: copyImage, icon: "copy", keys: "Mod+Shift+C" },
  copyCommand: { group: "file", run: copyCommand, icon: "code" },
  bundle: { group: "file", run: shareBundle, icon: "export" },
  undo: { group: "edit", run: () => history("undo"), icon: "undo", keys: "Mod+z", enabled: () => documentState.value?.canUndo ?? false },
  redo: { group: "edit", run: () => history("redo"), icon: "redo", keys: "Mod+Shift+Z", enabled: () => documentState.value?.canRedo ?? false },
  duplicate: { group: "edit", run: () => withSelection(duplicate), icon: "copy", keys: "Mod+d" },
  delete: { group: "edit", run: () => withSelection(remove), icon: "trash", keys: "Delete" },
  rename: { group: "edit", run: askForName, icon: "rename", keys: "F2" },
  deselect: { group: "edit", run: () => select(null), keys: "Escape" },
  pause: { group: "render", run: () => rendering(isRunning() ? "pause" : "continue"), icon: "pause", keys: "p" },
  stop: { group: "render", run: () => rendering("stop"), icon: "stop" },
  restart: { group: "render", run: () => rendering("restart"), icon: "restart", keys: "Shift+R" },
  home: { group: "camera", run: () => attempt(cameraHome), icon: "home", keys: "Home" },
  fit: { group: "view", run: fit, icon: "fit", keys: "f" },
  actualSize: { group: "view", run: actualSize, icon: "actual", keys: "Shift+F" },
  zoomIn: { group: "view", run: () => zoomBy(Math.SQRT2), icon: "zoomIn", keys: "Mod+ArrowUp" },
  zoomOut: { group: "view", run: () => zoomBy(Math.SQRT1_2), icon: "zoomOut", keys: "Mod+ArrowDown" },
  snapshot: { group: "view", run: keepPicture, icon: "snapshot", keys: "k" },
  toolSelect: { group: "tools", run: choose("select"), icon: "select", keys: "1" },
  toolMove: { group: "tools", run: choose("move"), icon: "move", keys: "2" },
  toolRotate: { group: "tools", run: choose("rotate"), icon: "rotate", keys: "3" },
  toolScale: { group: "tools", run: choose("scale"), icon: "scale", keys: "4" },
  toolFocus: { group: "tools", run: choose("focus"), icon: "focus", keys: "5" },
  toolInspect: { group: "tools", run: choose("inspect"), icon: "inspect", keys: "6" },
  toolRegion: { group: "tools", run: choose("region"), icon: "region", keys: "7" },
  showScene: { group: "view", run: toggle(leftOpen), icon: "scene", keys: "Alt+1" },
  showPanel: { group: "view", run: toggle(rightOpen), icon: "sliders", keys: "Alt+2" },
  showDock: { group: "view", run: toggle(bottomOpen), icon: "code", keys: "Alt+3" },
  source: { group: "view", run: () => showDock("source"), icon: "code", keys: "Alt+4" },
  inside: { group: "view", run: () => showDock("paths"), icon: "inspect", keys: "Alt+5" },
  theme: { group: "view", run: nextTheme, icon: "theme" },
  shortcuts: { group: "help", run: () => (dialog.value = "shortcuts"), icon: "help", keys: "?" },
  tour: { group: "help", run: () => (tourStep.value = 0), icon: "help" },
};

/** Keys may be quicker than the news of what can be done: the server knows, and does nothing where there is nothing to do. */
export const runCommand = (id: CommandId) => commands[id].run();

const isMac = /Mac|iPad|iPhone/.test(navigator.userAgent);
const symbols: Record<string, string> = { ArrowUp: "↑", ArrowDown: "↓", Mod: isMac ? "⌘" : "Ctrl", Delete: "Del", Escape: "Esc" };

/** "Mod+Shift+S" as it is printed on keyboards. */
export function keysText(keys: string): string {
  return keys.split("+").map((k) => symbols[k] ?? (k.length === 1 ? k.toUpperCase() : k)).join("+");
}

/** What a button for a command needs. */
export function commandButton(id: CommandId): ButtonProps {
  const { icon, keys, enabled } = commands[id];
  const [label, tip] = texts.commands[id];
  return { label: label.replace(" …", ""), tip, onClick: () => runCommand(id), ...(icon ? { icon } : {}), keys: keys && keysText(keys), disabled: enabled ? !enabled() : false };
}

/** What a menu's item for a command needs. */
export function commandItem(id: CommandId): MenuItem {
  const { keys, enabled } = commands[id];
  const [label, tip] = texts.commands[id];
  return { label, tip, run: () => runCommand(id), keys: keys && keysText(keys), disabled: enabled ? !enabled() : false };
}
