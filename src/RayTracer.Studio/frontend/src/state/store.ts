/** What all parts of the window look at. The server's state is taken as it comes; only what no server needs to know is kept here. */

import { batch, computed, effect, signal } from "@preact/signals";
import type { Unsent } from "../editor/unsent";
import type { ComparisonMap, Outline, TypeCatalogue, StudioState } from "../api/types";

export const studio = signal<StudioState | null>(null);
export const connection = signal<"waiting" | "open" | "lost" | "refused">("waiting");
export const schema = signal<TypeCatalogue | null>(null);
export const outline = signal<Outline | null>(null);

/** Ends when the page has the server's state of a version or a later one, or the server is gone. */
export const known = (version: number) =>
  new Promise<void>((done) => {
    const stop = effect(() => {
      if (connection.value !== "open" || (studio.value?.version ?? -1) >= version) queueMicrotask(() => (stop(), done()));
    });
  });

/** Ends when the page shows another document than one, or the server is gone. */
export const left = (document: number) =>
  new Promise<void>((done) => {
    const stop = effect(() => {
      if (connection.value !== "open" || studio.value?.document.document !== document) queueMicrotask(() => (stop(), done()));
    });
  });

// Slices: what reads one is drawn again only if that one changes.
const slice = <T>(pick: (state: StudioState) => T) => {
  let before: T | null = null;
  let written = "";
  return computed(() => {
    const state = studio.value;
    if (!state) return null;
    const now = pick(state);
    const text = JSON.stringify(now);
    if (text !== written) [before, written] = [now, text];
    return before;
  });
};

export const documentState = slice((s) => s.document);
export const renderState = slice((s) => s.render);
export const toneState = slice((s) => s.tone);
export const viewState = slice((s) => s.view);
/** The kept pictures of the scene that is open. */
export const snapshots = slice((s) => s.snapshots.filter((kept) => kept.document === s.document.document));

/** The name of what this page has asked to open, as long as the server reads it. */
export const opening = signal<string | null>(null);
/** The lights of the picture, where it keeps their light apart. */
export const mixedLights = slice((s) => s.lights);
export const recoveries = slice((s) => s.recovery);
export const jobs = slice((s) => s.jobs);
export const time = slice((s) => s.time);
/** The frame of the animation that the picture shows by now. */
export const shownFrame = computed(() => studio.value?.time.shown ?? null);
/** The thing that was selected last, and all that are selected. */
export const selection = computed(() => studio.value?.selection ?? null);
export const selected = slice((s) => s.selected);
/** The things that are left out of the view, and those that cannot be picked or dragged in it. */
export const hidden = slice((s) => s.hidden);
export const locked = slice((s) => s.locked);
export const revision = computed(() => studio.value?.document.revision ?? -1);
export const maps = computed(() => schema.value?.maps ?? []);
export const map = computed(() => studio.value?.render.map ?? "light");

/** Whether the picture is seen from beside the scene's camera. */
export const isOwnView = () => viewState.value?.isSceneCamera === false;

/** Whether this is a fresh Studio: its scene is the one that every Studio starts with, and nothing was done to it. */
export const isFresh = computed(() => {
  const doc = documentState.value;
  return doc !== null && doc.revision <= 1 && doc.path === null && !doc.isDirty;
});

export type Tool = "select" | "move" | "rotate" | "scale" | "focus" | "inspect" | "region";
export const tool = signal<Tool>("select");

/** The pixel whose paths are looked at, of the scene that is open. */
export const inspectedPixel = signal<{ x: number; y: number } | null>(null);

/** Takes the server's state. Another scene has nothing where the last one's pixel was: nobody asks for that in between. */
export const take = (state: StudioState) =>
  batch(() => {
    if (studio.peek() && studio.peek()!.document.document !== state.document.document) inspectedPixel.value = null;
    studio.value = state;
  });

/** Two kept pictures that are compared, and how; `right` is null for the picture that is rendered. */
export interface Comparison {
  left: number | null;
  right: number | null;
  shown: "wipe" | ComparisonMap;
}
export const comparison = signal<Comparison>({ left: null, right: null, shown: "wipe" });

/** The same of pictures that are still kept. */
export const compared = computed<Comparison>(() => {
  const kept = (id: number | null) => (snapshots.value?.some((s) => s.id === id) ? id : null);
  const { left, right, shown } = comparison.value;
  const isPair = kept(left) !== null && kept(right) !== null;
  return { left: kept(left), right: kept(right), shown: isPair ? shown : "wipe" };
});

/** Where the wipe is: 0 is the left edge. */
export const wipe = signal(0.5);

/** Text typed into a window whose server has gone, which the editor shall merge into the document's, or put in its place. */
export const mergeWanted = signal<{ unsent: Unsent; isWhole: boolean } | null>(null);

/** Whether the picture is shown alone, without bars and panes. */
export const pictureAlone = signal(false);

export type Dialog = "open" | "saveAs" | "export" | "background" | "lights" | "rename" | "shortcuts";
export const dialog = signal<Dialog | null>(null);
/** The page of the help that is open above all else, with the anchor of a section. */
export const helpAt = signal<{ page: string; section?: string | undefined } | null>(null);
/** What the dialog of renders to files begins with. */
export const backgroundKind = signal<"part" | "frames" | "merge">("part");
export const tourStep = signal<number | null>(null);

/** Where the source editor shall go; a new object each time. */
export const wantedPlace = signal<{ from: number; to: number } | null>(null);
