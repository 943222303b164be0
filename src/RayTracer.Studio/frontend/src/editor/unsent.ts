/** What was typed and did not reach the server is kept in the browser's storage, until it has, or somebody has merged or discarded it. */

import { ChangeSet } from "@codemirror/state";
import { difference } from "./sync";

export interface Unsent {
  /** The document's name. */
  name: string;
  time: string;
  /** The text that the server had. */
  base: string;
  /** The text as it was typed. */
  text: string;
}

const key = "studio.unsent";

export function keepUnsent(unsent: Unsent): void {
  try {
    localStorage.setItem(key, JSON.stringify(unsent));
  } catch {
    // A full or forbidden storage: the text still stands in the editor.
  }
}

export const forgetUnsent = () => localStorage.removeItem(key);

export function readUnsent(): Unsent | null {
  try {
    const found = JSON.parse(localStorage.getItem(key) ?? "null") as Partial<Unsent> | null;
    return found && [found.name, found.time, found.base, found.text].every((x) => typeof x === "string") ? (found as Unsent) : null;
  } catch {
    return null;
  }
}

/** The typed change, moved past what has changed in the text since. */
export function mergedChange({ base, text }: Unsent, current: string): ChangeSet {
  const change = (found: ReturnType<typeof difference>) => (found ? ChangeSet.of(found, base.length) : ChangeSet.empty(base.length));
  return change(difference(base, text)).map(change(difference(base, current)));
}
