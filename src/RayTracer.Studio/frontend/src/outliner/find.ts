import type { Outline, OutlineNode } from "../api/types";

/** The nodes of an outline in the order in which they are shown, each group under its key. */
export function nodesOf(outline: Outline): OutlineNode[] {
  const single = [outline.camera, outline.render, outline.background, outline.environment, outline.ambient].filter((n) => n !== null && n !== undefined);
  return [...single, ...outline.shapes, ...outline.lights, ...outline.materials, ...outline.textures, ...(outline.objects ?? [])];
}

/** The node of a pointer; null where there is none. */
export function findNode(outline: Outline | null, pointer: string): OutlineNode | null {
  const search = (nodes: OutlineNode[]): OutlineNode | null => {
    for (const node of nodes) {
      const found = node.pointer === pointer ? node : search(node.children ?? []);
      if (found) return found;
    }
    return null;
  };
  return outline && search(nodesOf(outline));
}

/** What is left of a tree when only nodes with this name or type, and those around them, are shown. */
export function filterNodes(nodes: OutlineNode[], text: string): OutlineNode[] {
  const wanted = text.trim().toLowerCase();
  if (!wanted) return nodes;
  return nodes.flatMap((node) => {
    const children = filterNodes(node.children ?? [], wanted);
    const fits = `${node.name} ${node.type}`.toLowerCase().includes(wanted);
    return fits || children.length ? [{ ...node, children }] : [];
  });
}
