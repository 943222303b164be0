import { autocompletion, closeBrackets, closeBracketsKeymap, completionKeymap } from "@codemirror/autocomplete";
import { defaultKeymap } from "@codemirror/commands";
import { bracketMatching, foldGutter, foldKeymap, indentUnit } from "@codemirror/language";
import { lintGutter, lintKeymap, setDiagnostics } from "@codemirror/lint";
import { highlightSelectionMatches, search, searchKeymap } from "@codemirror/search";
import { Annotation, EditorState, type ChangeSet } from "@codemirror/state";
import { drawSelection, EditorView, highlightActiveLine, highlightActiveLineGutter, keymap, lineNumbers } from "@codemirror/view";
import { effect } from "@preact/signals";
import { useLayoutEffect, useRef } from "preact/hooks";
import { get, post, Refusal } from "../api/client";
import type { PlacedDiagnostic } from "../api/types";
import { SchemaGuide, type Schema } from "../json/schema";
import { runCommand } from "../state/commands";
import { newGesture } from "../state/edits";
import { complain } from "../state/messages";
import { connection, documentState, mergeWanted, revision, schema, wantedPlace } from "../state/store";
import { texts } from "../texts";
import { completionSource, hover } from "./assist";
import { onFlush } from "./flush";
import { folding, highlighting, indentation, jsonc } from "./language";
import { TextSync, type SyncServer } from "./sync";
import { theme } from "./theme";
import { forgetUnsent, keepUnsent, mergedChange } from "./unsent";

const fromServer = Annotation.define<boolean>();
const burstPause = 1000;

const server: SyncServer = {
  read: () => get("document"),
  async write(change) {
    try {
      return await post("document/text", change);
    } catch (error) {
      if (error instanceof Refusal && typeof error.body.text === "string") return error.body as { revision: number; text: string };
      throw error;
    }
  },
};

/** Names one step of undo for all that is typed without a pause. */
function burstNames(): () => string {
  let gesture = "";
  let last = 0;
  return () => {
    const now = performance.now();
    if (now - last > burstPause) gesture = newGesture();
    last = now;
    return gesture;
  };
}

/** Keeps what the server did not take. */
function keep(sync: TextSync): void {
  const unsent = sync.unsentText();
  if (unsent) keepUnsent({ ...shownDocument(), time: new Date().toISOString(), ...unsent });
}

const shownDocument = () => ({ name: documentState.value?.name ?? "", path: documentState.value?.path ?? null });

function create(root: ShadowRoot, text: string, startRevision: number): { view: EditorView; sync: TextSync } {
  const nameBurst = burstNames();
  let guide: SchemaGuide | null = null;
  const currentGuide = () => (guide ??= schema.value ? new SchemaGuide(schema.value.schema as Schema) : null);
  const command = (id: "undo" | "redo" | "save") => () => (runCommand(id), true);

  const view: EditorView = new EditorView({
    parent: root,
    root,
    state: EditorState.create({
      doc: text,
      extensions: [
        lineNumbers(), highlightActiveLineGutter(), highlightActiveLine(), foldGutter(), folding, drawSelection(), bracketMatching(), closeBrackets(),
        indentUnit.of("  "), indentation, jsonc, highlighting, theme, EditorView.lineWrapping, search({ top: true }), highlightSelectionMatches(), lintGutter(),
        EditorState.lineSeparator.of("\n"),
        EditorView.contentAttributes.of({ "aria-label": texts.editor.label, tabindex: "0" }),
        autocompletion({ override: [completionSource(currentGuide)] }),
        hover(currentGuide),
        keymap.of([
          // The server keeps the history, as panels and handles change the text too.
          { key: "Mod-z", run: command("undo"), preventDefault: true },
          { key: "Mod-y", mac: "Mod-Shift-z", run: command("redo"), preventDefault: true },
          { key: "Mod-Shift-z", run: command("redo"), preventDefault: true },
          { key: "Mod-s", run: command("save"), preventDefault: true },
          ...closeBracketsKeymap, ...completionKeymap, ...searchKeymap, ...foldKeymap, ...lintKeymap, ...defaultKeymap,
        ]),
        EditorView.updateListener.of((update) => {
          const isOwn = update.transactions.some((t) => t.docChanged && !t.annotation(fromServer));
          if (!isOwn) return;
          sync.typed(update.changes, nameBurst());
          if (connection.value !== "open") keep(sync);
        }),
      ],
    }),
  });
  const apply = (changes: ChangeSet) => view.dispatch({ changes, annotations: fromServer.of(true) });
  const sync: TextSync = new TextSync(server, { apply }, view.state.doc, startRevision, (error) => {
    keep(sync);
    complain(error);
  });
  return { view, sync };
}

function showDiagnostics(view: EditorView, diagnostics: PlacedDiagnostic[]): void {
  const end = view.state.doc.length;
  const shown = diagnostics.map((d) => {
    const from = Math.min(d.from, end);
    return { from, to: Math.min(Math.max(d.to, from), end), severity: d.severity as "error" | "warning", message: d.message };
  });
  view.dispatch(setDiagnostics(view.state, shown));
}

/** Keeps the editor and everything else in step; ends with the function that it returns. */
function connect({ view, sync }: { view: EditorView; sync: TextSync }): () => void {
  onFlush(() => sync.flush());
  let wasLost = false;
  const stops = [
    effect(() => {
      if (connection.value === "open" && wasLost) {
        sync.retry();
        void sync.flush().then(() => sync.unsentText() === null && forgetUnsent(shownDocument()));
      }
      wasLost = connection.value !== "open";
    }),
    effect(() => {
      if (!mergeWanted.value) return;
      const { unsent, isWhole } = mergeWanted.value;
      mergeWanted.value = null;
      // Into the text that the document has now: it may have been opened for that just before.
      sync.remote(revision.peek());
      void sync.flush().then(() => {
        view.dispatch({ changes: mergedChange(unsent, view.state.doc.toString(), isWhole), scrollIntoView: true });
        return sync.flush().then(() => sync.unsentText() === null && forgetUnsent(unsent));
      });
    }),
    effect(() => sync.remote(revision.value)),
    effect(() => showDiagnostics(view, documentState.value?.diagnostics ?? [])),
    effect(() => {
      const place = wantedPlace.value;
      if (!place) return;
      const end = view.state.doc.length;
      const [anchor, head] = [Math.min(place.from, end), Math.min(place.to, end)];
      view.dispatch({ selection: { anchor, head }, effects: EditorView.scrollIntoView(anchor, { y: "center" }) });
      view.focus();
    }),
  ];
  return () => {
    stops.forEach((stop) => stop());
    onFlush(() => Promise.resolve());
    view.destroy();
  };
}

/**
 * The scene's text. It lives in a shadow root: there CodeMirror puts its styles into constructed sheets, where otherwise it would
 * need style elements, which the content security policy forbids.
 *
 * A layout effect, as those end with the element; others end only after the next frame, and the text may come before.
 */
export default function SourceEditor() {
  const host = useRef<HTMLDivElement>(null);
  useLayoutEffect(() => {
    const element = host.current!;
    let stop = () => undefined as void;
    let isGone = false;
    server.read().then(({ revision: start, text }) => {
      if (isGone) return;
      const root = element.shadowRoot ?? element.attachShadow({ mode: "open" });
      stop = connect(create(root, text, start));
    }, complain);
    return () => {
      isGone = true;
      stop();
    };
  }, []);
  return <div class="source" ref={host} />;
}
