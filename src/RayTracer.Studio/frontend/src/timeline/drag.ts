import { signal } from "@preact/signals";

/** By how many frames the chosen keys are dragged just now. */
export const dragBy = signal(0);

/** Whether motion paths are drawn over the picture. */
export const showsPaths = signal(true);
