/** Everything that a menu, a button or a key can do, once. */

import known from "../../../../RayTracer.Session/Texts/commands.json";
import { post } from "../api/client";
import type { Vec3 } from "../api/types";
import { flushEditor } from "../editor/flush";
import { copyCommand, copyImage, newScene, saveScene, shareBundle } from "../files/commands";
import { texts } from "../texts";
import type { ButtonProps } from "../ui/Button";
import type { MenuItem } from "../ui/Menu";
import type { IconName } from "../ui/Icon";
import { cameraHome, frame, keepView, lookAlong, setCamera } from "../viewport/camera";
import { actualSize, fit, zoomBy } from "../viewport/stage";
import { applyToSelected, askForName, duplicate, isSeen, remove, select, showAll, toggleHidden, toggleLocked, withSelection } from "./edits";
import { stepFrame, togglePlay } from "../timeline/frames";
import { placeOfAttention } from "../help/places";
import { attempt } from "./messages";
import { bottomOpen, bottomTab, leftOpen, leftTab, rightOpen, theme, type Theme } from "./settings";
import { backgroundKind, comparison, dialog, documentState, helpAt, hidden, renderState, pictureAlone, isOwnView, selection, time, tool, tourStep, type Tool } from "./store";

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
    const { id } = await post<{ id: number }>("view/snapshot");
    comparison.value = { left: id, right: null, shown: "wipe" };
  });

const along = (...from: Vec3) => ({ run: () => attempt(() => lookAlong(from)) });

const actions: Record<CommandId, Pick<Command, "run" | "enabled">> = {
  new: { run: () => newScene() },
  open: { run: () => (dialog.value = "open") },
  gallery: { run: () => ((leftOpen.value = true), (leftTab.value = "gallery")) },
  save: { run: () => saveScene() },
  saveAs: { run: () => (dialog.value = "saveAs") },
  export: { run: () => (dialog.value = "export") },
  copyImage: { run: copyImage },
  copyCommand: { run: copyCommand },
  bundle: { run: shareBundle },
  undo: { run: () => history("undo"), enabled: () => documentState.value?.canUndo ?? false },
  redo: { run: () => history("redo"), enabled: () => documentState.value?.canRedo ?? false },
  duplicate: { run: () => withSelection(duplicate) },
  delete: { run: () => withSelection(remove) },
  rename: { run: askForName },
  apply: { run: applyToSelected },
  hide: { run: () => withSelection(toggleHidden) },
  showAll: { run: showAll, enabled: () => (hidden.value?.length ?? 0) > 0 },
  lock: { run: () => withSelection(toggleLocked) },
  deselect: { run: () => (pictureAlone.value ? (pictureAlone.value = false) : select(null)) },
  pause: { run: () => rendering(isRunning() ? "pause" : "continue") },
  stop: { run: () => rendering("stop") },
  restart: { run: () => rendering("restart") },
  filter: { run: () => attempt(() => post("view/render", { filtersMotion: !renderState.value?.filtersMotion })) },
  background: { run: () => ((backgroundKind.value = "part"), (dialog.value = "background")) },
  lights: { run: () => (dialog.value = "lights") },
  home: { run: () => attempt(cameraHome), enabled: isOwnView },
  setCamera: { run: () => attempt(setCamera), enabled: isOwnView },
  frame: { run: () => attempt(() => frame(isSeen(selection.value) ? selection.value : null)) },
  alongX: along(1, 0, 0),
  alongMinusX: along(-1, 0, 0),
  alongY: along(0, 1, 0),
  alongMinusY: along(0, -1, 0),
  alongZ: along(0, 0, 1),
  alongMinusZ: along(0, 0, -1),
  bookmark: { run: () => attempt(keepView) },
  fit: { run: fit },
  actualSize: { run: actualSize },
  zoomIn: { run: () => zoomBy(Math.SQRT2) },
  zoomOut: { run: () => zoomBy(Math.SQRT1_2) },
  snapshot: { run: keepPicture },
  toolSelect: { run: choose("select") },
  toolMove: { run: choose("move") },
  toolRotate: { run: choose("rotate") },
  toolScale: { run: choose("scale") },
  toolFocus: { run: choose("focus") },
  toolInspect: { run: choose("inspect") },
  toolRegion: { run: choose("region") },
  showScene: { run: toggle(leftOpen) },
  showPanel: { run: toggle(rightOpen) },
  showDock: { run: toggle(bottomOpen) },
  timeline: { run: () => showDock("timeline") },
  play: { run: togglePlay, enabled: () => (time.value?.frames ?? 0) > 0 },
  frameBefore: { run: () => stepFrame(-1) },
  frameAfter: { run: () => stepFrame(1) },
  animate: { run: () => ((backgroundKind.value = "frames"), (dialog.value = "background")) },
  source: { run: () => showDock("source") },
  inside: { run: () => showDock("paths") },
  alone: { run: toggle(pictureAlone) },
  theme: { run: nextTheme },
  help: { run: () => (helpAt.value = placeOfAttention()) },
  lessons: { run: () => (helpAt.value = { page: "primer/README" }) },
  shortcuts: { run: () => (dialog.value = "shortcuts") },
  tour: { run: () => (tourStep.value = 0) },
};

/** What a command does here, with what all faces of the session know about it. */
export const commands = Object.fromEntries(
  Object.entries(known).map(([id, about]) => [id, { ...about, ...actions[id as CommandId] }]),
) as Record<CommandId, Command>;

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
