/** The links of the help's pages. */

/** Where a link leads: to a page, to a scene of the gallery, to a section of the same page, away, or to a file that only the sources have. */
export type Target =
  | { kind: "page"; page: string; section?: string }
  | { kind: "scene"; galleryId: string }
  | { kind: "section"; section: string }
  | { kind: "web" }
  | { kind: "file"; path: string };

export function targetOf(href: string): Target {
  const page = /^#help=([^&]+)(?:&section=(.*))?$/.exec(href);
  if (page) return page[2] ? { kind: "page", page: page[1]!, section: page[2] } : { kind: "page", page: page[1]! };
  const scene = /^#file=scenes\/(.+\.json)$/.exec(href);
  if (scene && !scene[1]!.endsWith(".schema.json") && !scene[1]!.startsWith("broken/")) return { kind: "scene", galleryId: scene[1]! };
  if (href.startsWith("#file=")) return { kind: "file", path: href.slice("#file=".length) };
  return href.startsWith("#") ? { kind: "section", section: href.slice(1) } : { kind: "web" };
}
