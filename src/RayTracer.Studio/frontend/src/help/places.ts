/** Which page of the help is about what somebody looks at: parts of the window say so by `data-help`, "page#section". */

import { helpAt } from "../state/store";

const whole = "studio";

/** What the pointer or the keyboard was at last. */
let attention: Element | null = null;

/** "scene-format#sphere" as a page and a section. */
export function readPlace(text: string): { page: string; section?: string } {
  const [page, section] = text.toLowerCase().split("#");
  return section ? { page: page!, section } : { page: page! };
}

export const placeOf = (element: Element | null) => readPlace(element?.closest<HTMLElement>("[data-help]")?.dataset.help ?? whole);

export const placeOfAttention = () => placeOf(attention?.isConnected ? attention : null);

/** F1 works in dialogs and fields, too, and loses nothing in them: the help opens above. */
export function watchAttention(): () => void {
  const look = (e: Event) => (attention = e.target instanceof Element ? e.target : null);
  const onKeyDown = (e: KeyboardEvent) => {
    if (e.key !== "F1") return;
    e.preventDefault();
    helpAt.value ??= placeOfAttention();
  };
  const events = ["pointermove", "focusin"] as const;
  for (const name of events) document.addEventListener(name, look, { passive: true });
  document.addEventListener("keydown", onKeyDown, { capture: true });
  return () => {
    for (const name of events) document.removeEventListener(name, look);
    document.removeEventListener("keydown", onKeyDown, { capture: true });
  };
}
