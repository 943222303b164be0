/** What was typed and did not reach the server is kept in the browser's storage, until it has, or somebody has merged or discarded it. */

import { ChangeSet } from "@codemirror/state";
import { signal } from "@preact/signals";
import { difference, fingerprint } from "./sync";

/** Which document it is. */
export interface DocumentName {
  name: string;
  /** Its file; null where it has none. */
  path: string | null;
}

export interface Unsent extends DocumentName {
  time: string;
  /** The text that the server had. */
  base: string;
  /** The fingerprints of the texts that it has had. */
  passed: string[];
  /** The text as it was typed. */
  text: string;
}

const key = "studio.unsent";

const isUnsent = (found: Partial<Unsent> | null): found is Unsent =>
  found !== null && [found.name, found.time, found.base, found.text].every((x) => typeof x === "string") && Array.isArray(found.passed);

function read(): Unsent[] {
  try {
    const found = JSON.parse(localStorage.getItem(key) ?? "[]") as (Partial<Unsent> | null)[];
    return Array.isArray(found) ? found.filter(isUnsent) : [];
  } catch {
    return [];
  }
}

function write(all: Unsent[]): void {
  try {
    if (all.length > 0) localStorage.setItem(key, JSON.stringify(all));
    else localStorage.removeItem(key);
  } catch {
    // A full or forbidden storage: the text still stands in the editor.
  }
}

export const isOf = (unsent: DocumentName, document: DocumentName) => unsent.name === document.name && unsent.path === document.path;

/** What earlier windows could not send, of all documents. */
export const unsentBefore = signal<Unsent[]>(read());

export const keepUnsent = (unsent: Unsent) => write([...read().filter((u) => !isOf(u, unsent)), unsent]);

export function forgetUnsent(document: DocumentName): void {
  write(read().filter((u) => !isOf(u, document)));
  unsentBefore.value = unsentBefore.value.filter((u) => !isOf(u, document));
}

/**
 * The typed change, moved past what has changed in the text since. Where nothing has, but that the server's end took some of the last changes with it,
 * the text becomes as it was typed; so it does in a document that is there for nothing else.
 */
export function mergedChange({ base, text, passed }: Unsent, current: string, isWhole = false): ChangeSet {
  const change = (from: string, to: string) => {
    const found = difference(from, to);
    return found ? ChangeSet.of(found, from.length) : ChangeSet.empty(from.length);
  };
  return isWhole || passed.includes(fingerprint(current)) ? change(current, text) : change(base, text).map(change(base, current));
}
