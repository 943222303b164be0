/** What the window remembers from one time to the next, in the browser's own storage. */

import { effect, signal, type Signal } from "@preact/signals";

function remembered<T>(name: string, initial: T): Signal<T> {
  const key = `studio.${name}`;
  let start = initial;
  try {
    const text = localStorage.getItem(key);
    const value: unknown = text === null ? null : JSON.parse(text);
    if (typeof value === typeof initial && value !== null) start = value as T;
  } catch {
    // Storage may be forbidden, or hold what an older version wrote.
  }
  const result = signal(start);
  effect(() => {
    const text = JSON.stringify(result.value);
    try {
      localStorage.setItem(key, text);
    } catch {
      // Then it is forgotten at the end of this window.
    }
  });
  return result;
}

/** A window this narrow (a small one, or one at 200 % zoom) has room for one pane at a time. */
export const narrowWindow = matchMedia("(max-width: 68rem)");

export const leftWidth = remembered("leftWidth", 256);
export const rightWidth = remembered("rightWidth", 336);
export const bottomHeight = remembered("bottomHeight", 264);

const isNarrow = signal(narrowWindow.matches);
narrowWindow.addEventListener("change", () => (isNarrow.value = narrowWindow.matches));

// In a narrow window panes lie over the picture: there they are closed at first, whatever is open in a wide one.
function paneOpen(name: string): { value: boolean } {
  const [wide, narrow] = [remembered(name, true), signal(false)];
  const now = () => (isNarrow.value ? narrow : wide);
  return {
    get value() {
      return now().value;
    },
    set value(isOpen) {
      now().value = isOpen;
    },
  };
}

export const leftOpen = paneOpen("leftOpen");
export const rightOpen = paneOpen("rightOpen");
export const bottomOpen = paneOpen("bottomOpen");

export const leftTab = remembered<string>("leftTab", "scene");
export const rightTab = remembered<string>("rightTab", "object");
export const bottomTab = remembered<string>("bottomTab", "source");
export const tourSeen = remembered("tourSeen", false);

export type Theme = "system" | "light" | "dark";
export const theme = remembered<Theme>("theme", "system");

effect(() => {
  document.documentElement.dataset.theme = theme.value;
});

const systemDark = matchMedia("(prefers-color-scheme: dark)");
const systemIsDark = signal(systemDark.matches);
systemDark.addEventListener("change", () => (systemIsDark.value = systemDark.matches));

export const isDark = () => theme.value === "dark" || (theme.value === "system" && systemIsDark.value);
