import { ChangeSet, Text } from "@codemirror/state";
import { describe, expect, test } from "vitest";
import { difference, fingerprint, TextSync, type SyncServer } from "../src/editor/sync";

/** A server as the Studio's: it knows one text, and takes changes of the newest revision only. */
class FakeServer implements SyncServer {
  revision = 1;
  delay = () => Promise.resolve();

  constructor(public text: string) {}

  async read() {
    await this.delay();
    return { revision: this.revision, text: this.text };
  }

  async write(change: { baseRevision: number; from: number; to: number; insert: string }) {
    await this.delay();
    if (change.baseRevision !== this.revision) return { revision: this.revision, text: this.text };
    this.replace(change.from, change.to, change.insert);
    return { revision: this.revision };
  }

  replace(from: number, to: number, insert: string) {
    this.text = this.text.slice(0, from) + insert + this.text.slice(to);
    this.revision++;
  }
}

/** An editor: what it shows, and what is typed into it. */
class FakeEditor {
  shown: Text;
  sync: TextSync;

  constructor(server: FakeServer, failed?: (error: unknown) => void) {
    this.shown = Text.of(server.text.split("\n"));
    const fail = (error: unknown) => {
      throw error;
    };
    this.sync = new TextSync(server, { apply: (changes) => (this.shown = changes.apply(this.shown)) }, this.shown, server.revision, failed ?? fail);
  }

  type(from: number, to: number, insert: string) {
    const changes = ChangeSet.of({ from, to, insert }, this.shown.length);
    this.shown = changes.apply(this.shown);
    this.sync.typed(changes, "g");
  }
}

describe("the editor's text", () => {
  test("is known with all that the server has had, while it is gone", async () => {
    const server = new FakeServer("abc");
    const editor = new FakeEditor(server, () => undefined);
    editor.type(0, 0, "x");
    await editor.sync.flush();
    server.delay = () => Promise.reject(new TypeError("gone"));
    editor.type(1, 1, "y");
    await editor.sync.flush();
    expect(editor.sync.unsentText()).toEqual({ base: "xabc", text: "xyabc", passed: ["abc", "xabc"].map(fingerprint) });
  });

  test("reaches the server as it is typed", async () => {
    const server = new FakeServer("abc");
    const editor = new FakeEditor(server);
    editor.type(1, 1, "x");
    editor.type(2, 2, "y");
    await editor.sync.flush();
    editor.type(0, 1, "");
    await editor.sync.flush();
    expect(server.text).toBe("xybc");
  });

  test("takes over what others change", async () => {
    const server = new FakeServer("one two three");
    const editor = new FakeEditor(server);
    server.replace(4, 7, "2");
    editor.sync.remote(server.revision);
    await editor.sync.flush();
    expect(editor.shown.toString()).toBe("one 2 three");
  });

  test("keeps both changes when both happen at once", async () => {
    const server = new FakeServer("one two three");
    const editor = new FakeEditor(server);
    server.replace(0, 3, "1");
    editor.type(13, 13, "!");
    editor.sync.remote(server.revision);
    await editor.sync.flush();
    expect(server.text).toBe("1 two three!");
    expect(editor.shown.toString()).toBe(server.text);
  });

  test("is known whole as long as the server has not got it, while it is sent, too", async () => {
    const server = new FakeServer("abc");
    let arrive = () => {};
    server.delay = () => new Promise((resolve) => (arrive = resolve));
    const editor = new FakeEditor(server);
    editor.type(0, 0, "1");
    await Promise.resolve();
    await Promise.resolve();
    editor.type(1, 1, "2");
    expect(editor.sync.unsentText()).toMatchObject({ base: "abc", text: "12abc" });
    arrive();
    await new Promise((resolve) => setTimeout(resolve));
    expect(editor.sync.unsentText()).toMatchObject({ base: "1abc", text: "12abc" });
    arrive();
    await editor.sync.flush();
    expect(editor.sync.unsentText()).toBeNull();
  });

  test("is the server's after any mixture of changes", async () => {
    for (let seed = 1; seed <= 40; seed++) {
      let state = seed * 2654435761;
      const random = (n: number) => (state = (Math.imul(state, 1664525) + 1013904223) >>> 0) % n;
      const server = new FakeServer("0123456789");
      server.delay = () => new Promise((resolve) => setTimeout(resolve, random(3)));
      const editor = new FakeEditor(server);
      for (let step = 0; step < 30; step++) {
        const isRemote = random(3) === 0;
        const size = isRemote ? server.text.length : editor.shown.length;
        const from = random(size + 1);
        const to = Math.min(size, from + random(3));
        if (isRemote) {
          server.replace(from, to, "r".repeat(random(3)));
          editor.sync.remote(server.revision);
        } else editor.type(from, to, "e".repeat(random(3)));
        if (random(2) === 0) await new Promise((resolve) => setTimeout(resolve, random(2)));
      }
      await editor.sync.flush();
      expect(editor.shown.toString(), `seed ${seed}`).toBe(server.text);
    }
  });
});

test("the difference of two texts is one stretch, and nothing for equal ones", () => {
  expect(difference("abcdef", "abXef")).toEqual({ from: 2, to: 4, insert: "X" });
  expect(difference("aaa", "aaaa")).toEqual({ from: 3, to: 3, insert: "a" });
  expect(difference("same", "same")).toBeNull();
});
