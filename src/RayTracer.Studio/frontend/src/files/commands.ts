/** Opening, saving and sharing. */

import { signal } from "@preact/signals";
import { getBlob, get, post, Refusal, token, upload } from "../api/client";
import { attempt, say } from "../state/messages";
import { dialog, documentState, left, opening, isOwnView } from "../state/store";
import { leftOpen, narrowWindow } from "../state/settings";
import { flushEditor } from "../editor/flush";
import { texts } from "../texts";
import { nameOf, withExtension } from "./paths";

/** A step that needs an answer about unsaved changes first. */
export const unsavedQuestion = signal<{ go: () => Promise<void> } | null>(null);

/** What follows once a scene that has no file yet has one: "save as" is open for it. */
export const afterSaving = signal<(() => Promise<void>) | undefined>(undefined);

/** A file that would be replaced. */
export const overwriteQuestion = signal<{ path: string; why: string; go: () => Promise<void> } | null>(null);

/** Does what would lose changes; asks first where there are some. */
async function leaving(step: (discard: boolean) => Promise<unknown>): Promise<void> {
  await flushEditor();
  if (documentState.value?.isDirty) {
    unsavedQuestion.value = { go: async () => void (await step(true)) };
    return;
  }
  try {
    await step(false);
  } catch (error) {
    if (!(error instanceof Refusal && error.body.unsaved === true)) throw error;
    unsavedQuestion.value = { go: async () => void (await step(true)) };
  }
}

type Source = { path: string } | { galleryId: string } | { recoveryId: string };

/** Says at once what is being opened: reading a large file takes a while. */
async function showing(name: string, work: () => Promise<unknown>): Promise<void> {
  opening.value = name;
  try {
    await work();
  } finally {
    opening.value = null;
  }
}

const namedBy = (source: Source) => nameOf(("path" in source && source.path) || ("galleryId" in source && source.galleryId) || texts.untitled);

export const openScene = (source: Source) =>
  attempt(() =>
    leaving(async (discard) => {
      await showing(namedBy(source), () => post("file/open", { ...source, discard }));
      // There, the pane would hide what was opened.
      if (narrowWindow.matches) leftOpen.value = false;
    }),
  );
export const newScene = (then?: () => void) =>
  attempt(() =>
    leaving(async (discard) => {
      const before = documentState.peek()?.document ?? -1;
      await post("file/new", { discard });
      await left(before);
      then?.();
    }),
  );
export const discardRecovery = (id: string) => attempt(() => post("recovery/discard", { id }));

export const openDropped = (file: File) =>
  attempt(() => leaving((discard) => showing(file.name, () => upload("file/upload", { name: file.name, discard: discard ? "true" : undefined }, file))));

/** Writes something to a path, and goes on with what waits for that; asks before a file is replaced. */
async function writing(path: string, write: (overwrite: boolean) => Promise<unknown>, then?: () => Promise<void>): Promise<void> {
  try {
    await write(false);
  } catch (error) {
    if (!(error instanceof Refusal && (error.body.exists === true || error.body.changedOnDisk === true))) throw error;
    const go = async () => {
      await write(true);
      await then?.();
    };
    overwriteQuestion.value = { path, why: error.message, go };
    return;
  }
  await then?.();
}

/** Saves the scene where it lies, and goes on with what waits for that. */
export const saveScene = (then?: () => Promise<void>) =>
  attempt(async () => {
    await flushEditor();
    const path = documentState.value?.path;
    if (path) {
      await writing(path, (overwrite) => post("file/save", { overwrite }), then);
      return;
    }
    afterSaving.value = then;
    dialog.value = "saveAs";
  });

export const saveSceneAs = (path: string, then?: () => Promise<void>) =>
  attempt(async () => {
    await flushEditor();
    await writing(path, (overwrite) => post("file/save", { path, overwrite }), then);
  });

export interface PictureOptions {
  format: string;
  bitDepth: number;
  layers: string[];
  /** What is seen instead of what the scene's camera sees. */
  asSeen: boolean;
  transparent: boolean;
}

export const savePicture = (path: string, options: PictureOptions) => {
  const { bitDepth, layers, asSeen, transparent } = options;
  return attempt(() => writing(path, (overwrite) => post("save/picture", { path, bitDepth, layers, asSeen, transparent, overwrite })));
};

/** Starts something that is rendered into files beside the user's work. */
export const startBackground = (what: string, path: string, request: object) =>
  attempt(async () => {
    await flushEditor();
    await writing(path, (overwrite) => post(`background/${what}`, { ...request, path, overwrite }));
  });

/** Renders a picture with a layer for each light, or writes one whose lights are balanced. */
export const startLights = (what: "render" | "save", path: string, request: object) =>
  attempt(() => writing(path, (overwrite) => post(`lights/${what}`, { ...request, path, overwrite })));

function download(blob: Blob, name: string): void {
  const link = document.createElement("a");
  link.href = URL.createObjectURL(blob);
  link.download = name;
  link.click();
  setTimeout(() => URL.revokeObjectURL(link.href), 10_000);
}

/** What files made from this scene are called. */
export const sceneName = () => documentState.value?.name || "scene.json";

export const downloadPicture = ({ format, bitDepth, layers }: Omit<PictureOptions, "asSeen" | "transparent">) =>
  attempt(async () => {
    const query = { format, bitDepth, layers: layers.length ? layers.join(",") : undefined };
    download(await getBlob("picture", query), nameOf(withExtension(sceneName(), format)));
  });

export const shareBundle = () =>
  attempt(async () => {
    await flushEditor();
    download(await getBlob("file/bundle"), nameOf(withExtension(sceneName(), "zip")));
  });

export const copyCommand = () =>
  attempt(async () => {
    const { text } = await get<{ text: string }>("command");
    await toClipboard(() => navigator.clipboard.writeText(text), (isOwnView() ? texts.messages.copiedCommandOfScene : texts.messages.copiedCommand)(text));
  });

export const copyImage = () =>
  attempt(() => {
    // The clipboard takes a promise, so that the click still counts as the reason.
    const item = new ClipboardItem({ "image/png": getBlob("picture", { format: "png", bitDepth: 8 }) });
    return toClipboard(() => navigator.clipboard.write([item]), texts.messages.copiedImage);
  });

async function toClipboard(write: () => Promise<void>, done: string): Promise<void> {
  try {
    await write();
    say("info", done);
  } catch {
    say("error", texts.messages.cannotCopy);
  }
}

/** The address of a picture that an image element cannot fetch by itself, as it sends no header: its bytes as a blob. */
export async function pictureAddress(path: string, query: Record<string, string | number>): Promise<string> {
  return token ? URL.createObjectURL(await getBlob(path, query)) : "";
}
