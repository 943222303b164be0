/** Keys of the window. Parts that use keys themselves (fields, lists, the picture) keep them from coming here. */

import { commands, runCommand, type CommandId } from "./commands";

export interface Press {
  key: string;
  ctrlKey: boolean;
  metaKey: boolean;
  shiftKey: boolean;
  altKey: boolean;
}

/** The command of a key; null where there is none. Shift counts by what it makes of the key. */
export function commandOf(press: Press): CommandId | null {
  const mod = press.ctrlKey || press.metaKey;
  for (const [id, { keys }] of Object.entries(commands)) {
    if (!keys) continue;
    const parts = keys.split("+");
    const key = parts.at(-1)!;
    const wantsShift = parts.includes("Shift");
    const fits = mod === parts.includes("Mod") && press.altKey === parts.includes("Alt") && (wantsShift === press.shiftKey || key === "?");
    if (fits && press.key.toLowerCase() === key.toLowerCase()) return id as CommandId;
  }
  return null;
}

const writes = (element: Element | undefined) =>
  element instanceof HTMLElement && (element.isContentEditable || element.matches("input:not([type=range], [type=checkbox], [type=radio], [type=color]), textarea, select"));

export function listenToShortcuts(): () => void {
  const onKeyDown = (e: KeyboardEvent) => {
    if (e.defaultPrevented || document.querySelector("dialog[open]")) return;
    const id = commandOf(e);
    if (!id) return;
    // Where text is written, only keys with Ctrl or Alt are commands, and undo is the scene's, not the field's.
    const isPlain = !e.ctrlKey && !e.metaKey && !e.altKey;
    if (isPlain && writes(e.composedPath()[0] as Element | undefined)) return;
    e.preventDefault();
    runCommand(id);
  };
  document.addEventListener("keydown", onKeyDown);
  return () => document.removeEventListener("keydown", onKeyDown);
}
