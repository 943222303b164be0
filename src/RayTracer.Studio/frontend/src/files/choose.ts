import { signal } from "@preact/signals";
import { documentState } from "../state/store";
import { relativeTo } from "./paths";

/** What to do with a file that the user is being asked for; null while no one asks. */
export const fileWanted = signal<((path: string) => void) | null>(null);

/** Asks for a picture or a model that exists; the answer is its path as the scene writes it. */
export const chooseFile = (then: (file: string) => void) => (fileWanted.value = (path) => then(relativeTo(documentState.value?.path ?? null, path)));
