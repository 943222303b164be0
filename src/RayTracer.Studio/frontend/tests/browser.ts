/** As much of a browser as modules ask for when they are loaded. */

import { vi } from "vitest";

export function pretendBrowser(): void {
  const query = { matches: false, addEventListener: () => undefined };
  const storage = { getItem: () => null, setItem: () => undefined };
  vi.stubGlobal("location", { hash: "", pathname: "/" });
  vi.stubGlobal("sessionStorage", storage);
  vi.stubGlobal("localStorage", storage);
  vi.stubGlobal("matchMedia", () => query);
  vi.stubGlobal("navigator", { userAgent: "" });
  vi.stubGlobal("document", { documentElement: { dataset: {} } });
}
