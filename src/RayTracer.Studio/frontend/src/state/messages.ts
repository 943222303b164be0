/** Short messages that appear over the window and can be dismissed. */

import { signal } from "@preact/signals";
import { post, Refusal } from "../api/client";
import { texts } from "../texts";

export interface Message {
  id: number;
  kind: "info" | "error";
  text: string;
}

export const messages = signal<Message[]>([]);

const infoStaysFor = 6000;
const shownAtOnce = 4;
let lastId = 0;

export function say(kind: Message["kind"], text: string): void {
  const others = messages.value.filter((m) => m.text !== text);
  const id = ++lastId;
  messages.value = [...others, { id, kind, text }].slice(-shownAtOnce);
  if (kind === "info") setTimeout(() => dismiss(id), infoStaysFor);
}

export function dismiss(id: number): void {
  messages.value = messages.value.filter((m) => m.id !== id);
}

/** Shows why the server said no. Lost connections are not shown here: the banner shows them. */
export function complain(error: unknown): void {
  if (error instanceof Refusal) say("error", error.message);
  else if (!(error instanceof TypeError) && !(error instanceof DOMException)) throw error;
}

/** Runs a command of the user; what goes wrong becomes a message. */
export function attempt(work: () => Promise<unknown>): void {
  work().catch(complain);
}

/** Faults of this page go to the server's log, where they are found for a report. */
export function reportFaults(): void {
  const report = (text: string) => {
    say("error", texts.messages.pageError(text.split("\n")[0] ?? ""));
    post("log", { text }).catch(() => undefined);
  };
  const reportError = (error: unknown, fallback: string) => report(error instanceof Error ? `${error.message}\n${error.stack ?? ""}` : fallback);
  window.addEventListener("error", (e) => reportError(e.error, e.message));
  window.addEventListener("unhandledrejection", (e) => reportError(e.reason, String(e.reason)));
}
