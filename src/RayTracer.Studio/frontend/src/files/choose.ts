import { signal } from "@preact/signals";

/** What to do with a file that the user is being asked for; null while no one asks. */
export const fileWanted = signal<((path: string) => void) | null>(null);

/** Asks for a picture or a model that exists. */
export const chooseFile = (then: (path: string) => void) => (fileWanted.value = then);
