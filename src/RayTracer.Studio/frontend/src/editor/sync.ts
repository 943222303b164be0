/**
 * Keeps the editor's text and the server's the same. What is typed is sent as one change at a time; what others (panels, gizmos,
 * undo) change is fetched and moved past what was typed meanwhile.
 */

import { ChangeSet, type Text } from "@codemirror/state";

export interface SyncServer {
  read(): Promise<{ revision: number; text: string }>;
  /** Answers with the server's text where the revision is old. */
  write(change: { baseRevision: number; from: number; to: number; insert: string; gesture: string }): Promise<{ revision: number; text?: string }>;
}

export interface SyncView {
  /** Applies a change of the server to what is shown. */
  apply(changes: ChangeSet): void;
}

/** The one stretch that differs between two texts. */
export function difference(before: string, after: string): { from: number; to: number; insert: string } | null {
  if (before === after) return null;
  const shortest = Math.min(before.length, after.length);
  let start = 0;
  while (start < shortest && before.charCodeAt(start) === after.charCodeAt(start)) start++;
  let end = 0;
  while (end < shortest - start && before.charCodeAt(before.length - 1 - end) === after.charCodeAt(after.length - 1 - end)) end++;
  return { from: start, to: before.length - end, insert: after.slice(start, after.length - end) };
}

/** A change as the one stretch from its first to its last difference. */
export function asOne(changes: ChangeSet, before: Text): { from: number; to: number; insert: string } {
  let from = before.length;
  let to = 0;
  changes.iterChangedRanges((a, b) => {
    from = Math.min(from, a);
    to = Math.max(to, b);
  });
  const after = changes.apply(before);
  return { from, to, insert: after.sliceString(from, to + after.length - before.length) };
}

/** A short name of a text, by which it is known again: its length, and its hash (Fowler, Noll & Vo 1991, FNV-1a by characters). */
export function fingerprint(text: string): string {
  let hash = 0x811c9dc5;
  for (let i = 0; i < text.length; i++) hash = Math.imul(hash ^ text.charCodeAt(i), 0x01000193);
  return `${text.length}-${(hash >>> 0).toString(36)}`;
}

// The first is that of the file, mostly; of the others, a server that was gone comes back with one of the last.
const mostPassed = 1000;

export class TextSync {
  private unsent: ChangeSet;
  /** Which texts the server has had. */
  private passed: string[];
  /** What is on its way to the server: it comes before what is unsent. */
  private sent: ChangeSet | null = null;
  private working: Promise<void> | null = null;
  private gesture = "";
  private wanted = -1;

  constructor(
    private server: SyncServer,
    private view: SyncView,
    private base: Text,
    private revision: number,
    private failed: (error: unknown) => void,
  ) {
    this.unsent = ChangeSet.empty(base.length);
    this.passed = [fingerprint(base.toString())];
  }

  /** The user changed what is shown. */
  typed(changes: ChangeSet, gesture: string): void {
    this.unsent = this.unsent.compose(changes);
    this.gesture = gesture;
    void this.work();
  }

  /** The server's text has this revision now. */
  remote(revision: number): void {
    this.wanted = Math.max(this.wanted, revision);
    void this.work();
  }

  /** The server is back: sends what it did not take. */
  retry(): void {
    void this.work();
  }

  /** The server's text as far as it is known, which it has had, and what it should be; null where the server has it all. */
  unsentText(): { base: string; text: string; passed: string[] } | null {
    const own = this.sent?.compose(this.unsent) ?? this.unsent;
    return own.empty ? null : { base: this.base.toString(), text: own.apply(this.base).toString(), passed: this.passed };
  }

  /** Ends when the server knows all that was typed. */
  async flush(): Promise<void> {
    while (this.working) await this.working;
  }

  // After a failure nothing is tried until something is typed or the server reports a change.
  private work(): Promise<void> {
    this.working ??= this.run()
      .catch(this.failed)
      .finally(() => (this.working = null));
    return this.working;
  }

  private async run(): Promise<void> {
    // What is typed within one task goes in one change.
    await Promise.resolve();
    while (!this.unsent.empty || this.wanted > this.revision) {
      if (!this.unsent.empty) await this.send();
      else this.take(await this.server.read(), ChangeSet.empty(this.base.length));
    }
  }

  private async send(): Promise<void> {
    const sent = this.unsent;
    this.sent = sent;
    this.unsent = ChangeSet.empty(sent.newLength);
    try {
      const answer = await this.server.write({ baseRevision: this.revision, ...asOne(sent, this.base), gesture: this.gesture });
      if (answer.text !== undefined) {
        this.take({ revision: answer.revision, text: answer.text }, sent);
      } else {
        this.become(sent.apply(this.base), answer.revision);
      }
    } catch (error) {
      this.unsent = sent.compose(this.unsent);
      throw error;
    } finally {
      this.sent = null;
    }
  }

  /** Takes the server's text over, and moves what it does not know yet past it. */
  private take(answer: { revision: number; text: string }, sent: ChangeSet): void {
    const own = sent.compose(this.unsent);
    const found = difference(this.base.toString(), answer.text);
    const theirs = found ? ChangeSet.of(found, this.base.length) : ChangeSet.empty(this.base.length);
    this.unsent = own.map(theirs);
    this.become(theirs.apply(this.base), answer.revision);
    if (found) this.view.apply(theirs.map(own, true));
  }

  private become(base: Text, revision: number): void {
    [this.base, this.revision] = [base, revision];
    this.passed.push(fingerprint(base.toString()));
    if (this.passed.length > mostPassed) this.passed.splice(1, 1);
  }
}
