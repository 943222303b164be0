import type { Outline, OutlineNode } from "../api/types";
import { filterNodes } from "./find";

export type GroupKey = "shapes" | "lights" | "materials" | "textures" | "objects";
export type SectionKey = "camera" | "render" | "background" | "environment" | "ambient";

/** A line of the outliner: a section, the heading of a group, or a thing. */
export interface Row {
  kind: SectionKey | GroupKey;
  isHeading: boolean;
  level: number;
  pointer: string;
  /** Null for headings. */
  node: OutlineNode | null;
  /** Whether what it holds is shown; null where it holds nothing. */
  isOpen: boolean | null;
  count: number;
}

const sections: SectionKey[] = ["camera", "render", "background", "environment", "ambient"];
const groups: GroupKey[] = ["shapes", "lights", "materials", "textures", "objects"];

/** Whether there is an environment. */
export const isSurrounded = (outline: Outline | null) => !!outline?.environment && outline.environment.summary !== "none";

/** The lines of the tree from top to bottom, without what is closed or does not fit the filter. */
export function rowsOf(outline: Outline, closed: ReadonlySet<string>, filter: string): Row[] {
  const rows: Row[] = [];
  const add = (kind: Row["kind"], node: OutlineNode, level: number) => {
    const children = node.children ?? [];
    const isOpen = !closed.has(node.pointer);
    rows.push({ kind, isHeading: false, level, pointer: node.pointer, node, isOpen: children.length ? isOpen : null, count: children.length });
    if (isOpen) for (const child of children) add(kind, child, level + 1);
  };
  for (const kind of sections) {
    const node = outline[kind];
    // An environment takes the place of the background.
    const isHidden = kind === "background" && isSurrounded(outline);
    if (node && !filter && !isHidden) add(kind, node, 1);
  }
  for (const kind of groups) {
    const nodes = filterNodes(outline[kind] ?? [], filter);
    if (nodes.length === 0 && (filter || kind === "objects")) continue;
    const pointer = `/${kind}`;
    const isOpen = !closed.has(pointer);
    rows.push({ kind, isHeading: true, level: 1, pointer, node: null, isOpen, count: nodes.length });
    if (isOpen) for (const node of nodes) add(kind, node, 2);
  }
  return rows;
}
