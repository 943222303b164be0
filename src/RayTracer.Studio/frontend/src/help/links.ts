/** The links of the help's pages. */

import type { Json } from "../api/types";

/** Where a link leads: to a page, to a scene of the gallery, to a section of the same page, away, or to a file that only the sources have. */
export type Target =
  | { kind: "page"; page: string; section?: string }
  | { kind: "scene"; galleryId: string }
  | { kind: "section"; section: string }
  | { kind: "try"; changes: Change[] }
  | { kind: "web" }
  | { kind: "file"; path: string };

/** A change of a lesson's scene. */
export interface Change {
  pointer: string;
  value: Json;
}

/** The changes of a link: paths in the scene with JSON values, "camera/verticalFov=40;shapes/0/radius=2". */
function changesOf(text: string): Change[] {
  return text.split(/;(?=[\w-]+[/=])/).map((change) => {
    const at = change.indexOf("=");
    return { pointer: `/${change.slice(0, at)}`, value: JSON.parse(change.slice(at + 1)) as Json };
  });
}

export function targetOf(href: string): Target {
  if (href.startsWith("try:")) return { kind: "try", changes: changesOf(decodeURIComponent(href.slice("try:".length))) };
  const page = /^#help=([^&]+)(?:&section=(.*))?$/.exec(href);
  if (page) return page[2] ? { kind: "page", page: page[1]!, section: page[2] } : { kind: "page", page: page[1]! };
  const scene = /^#file=scenes\/(.+\.json)$/.exec(href);
  if (scene && !scene[1]!.endsWith(".schema.json") && !scene[1]!.startsWith("broken/")) return { kind: "scene", galleryId: scene[1]! };
  if (href.startsWith("#file=")) return { kind: "file", path: href.slice("#file=".length) };
  return href.startsWith("#") ? { kind: "section", section: href.slice(1) } : { kind: "web" };
}
