/**
 * Fetches frames. The request for the next one is sent before this one is painted, and itself shows the server that there is
 * room for it; only if painting lags by a whole frame does it wait.
 */

import { readHeader } from "./frame";

export type ToWorker =
  | { kind: "start"; token: string }
  | { kind: "size"; width: number; height: number }
  | { kind: "watch"; isVisible: boolean }
  | { kind: "painted" };

const retryAfter = 1000;
// In pixels of the screen; 0 stands for the whole picture.
let size = { width: 0, height: 0 };
let version = 0;
let asking = new AbortController();
let isVisible = true;
let unpainted = 0;
let wake: () => void = () => undefined;

const mayAsk = () => isVisible && unpainted < 2;

async function follow(token: string): Promise<never> {
  for (;;) {
    while (!mayAsk()) await new Promise<void>((resolve) => (wake = resolve));
    try {
      const query = `after=${version}&width=${size.width}&height=${size.height}`;
      asking = new AbortController();
      const response = await fetch(`/api/frame?${query}`, { headers: { "X-Studio-Token": token }, signal: asking.signal });
      if (!response.ok) throw new Error(String(response.status));
      if (response.status === 204) continue;
      const bytes = await response.arrayBuffer();
      if (!asking.signal.aborted) version = readHeader(bytes).version;
      unpainted++;
      postMessage(bytes, { transfer: [bytes] });
    } catch {
      if (asking.signal.aborted) continue;
      // The page's own poll reports a lost connection to the user.
      version = 0;
      await new Promise((resolve) => setTimeout(resolve, retryAfter));
    }
  }
}

/** The picture is shown in another size: what is there may be too coarse now. */
function resize({ width, height }: { width: number; height: number }): void {
  if (width === size.width && height === size.height) return;
  size = { width, height };
  version = 0;
  asking.abort();
}

addEventListener("message", (event: MessageEvent<ToWorker>) => {
  const message = event.data;
  if (message.kind === "start") void follow(message.token);
  else if (message.kind === "size") resize(message);
  else if (message.kind === "watch") isVisible = message.isVisible;
  else unpainted = 0;
  if (mayAsk()) wake();
});
