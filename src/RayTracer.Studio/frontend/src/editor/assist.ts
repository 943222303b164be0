/** Completion and hover from the scene format's schema. */

import type { Completion, CompletionContext, CompletionResult } from "@codemirror/autocomplete";
import { hoverTooltip, type EditorView } from "@codemirror/view";
import { isInComment, locate, nodeAt, parseJsonc, plain } from "../json/jsonc";
import { SchemaGuide, type Schema } from "../json/schema";
import { texts } from "../texts";

/** Names that the document itself defines, where a place may refer to them. */
function namesFor(schemas: Schema[], document: unknown, path: readonly (string | number)[]): string[] {
  const scene = document as Record<string, Record<string, unknown> | undefined> | undefined;
  const key = String(path.findLast((p) => typeof p === "string") ?? "");
  const takesText = schemas.some((s) => s.type === "string");
  if (!takesText) return [];
  if (/^(material|diffuse|specular)$/i.test(key)) return Object.keys(scene?.materials ?? {});
  if (/^(color|even|odd|texture|first|second)$/.test(key)) return Object.keys(scene?.textures ?? {});
  return key === "of" ? Object.keys(scene?.objects ?? {}) : [];
}

/** What follows a key's colon at first, so that typing can go on inside. */
function starter(schema: Schema): string {
  if (schema.type === "array") return "[]";
  if (schema.type === "object") return "{}";
  return schema.type === "string" || schema.enum ? '""' : "";
}

function summary(schema: Schema): string {
  const byDefault = schema.default === undefined ? "" : ` ${texts.editor.byDefault(JSON.stringify(schema.default))}.`;
  return `${schema.description ?? ""}${byDefault}`.trim();
}

/** What can stand at a position of a text. */
export function complete(text: string, position: number, guide: SchemaGuide): { from: number; to: number; options: Completion[] } | null {
  if (isInComment(text, position)) return null;
  const root = parseJsonc(text);
  const document = plain(root);
  const { path, node, key } = locate(root, position);
  const word = /"?[\w#.-]*$/.exec(text.slice(0, position))![0];

  if (key || node.kind === "object") {
    const have = new Set(node.members.filter((m) => m !== key).map((m) => m.key));
    const from = key ? key.keyFrom : position - word.length;
    const hasColon = /^\s*:/.test(text.slice(key?.keyTo ?? position));
    const options = [...guide.members(path, document)].filter(([name]) => !have.has(name)).map(([name, schema]): Completion => ({
      label: `"${name}"`,
      type: "property",
      info: summary(schema),
      apply: hasColon ? `"${name}"` : (view, _, start, end) => insertMember(view, start, end, name, starter(schema)),
    }));
    return options.length ? { from, to: key ? key.keyTo : position, options } : null;
  }
  const holder = node.kind === "array" ? [...path, node.items.length] : path;
  const schemas = guide.at(holder, undefined);
  const words = [...guide.values(holder, document), ...namesFor(schemas, document, holder)];
  const isValue = node.kind === "string" || node.kind === "word";
  const options = [...new Set(words)].map((value): Completion => ({ label: JSON.stringify(value), type: "enum" }));
  return options.length ? { from: isValue ? node.from : position - word.length, to: isValue ? node.to : position, options } : null;
}

function insertMember(view: EditorView, from: number, to: number, name: string, value: string): void {
  const insert = `"${name}": ${value}`;
  view.dispatch({ changes: { from, to, insert }, selection: { anchor: from + insert.length - (value ? 1 : 0) }, userEvent: "input.complete" });
}

export const completionSource = (guide: () => SchemaGuide | null) => (context: CompletionContext): CompletionResult | null => {
  const known = guide();
  const typed = context.matchBefore(/["\w]/);
  if (!known || (!context.explicit && !typed)) return null;
  const result = complete(context.state.doc.toString(), context.pos, known);
  return result && { ...result, validFor: /^"?\w*"?$/ };
};

/** What the schema says about the key or value under the pointer. */
export function describe(text: string, position: number, guide: SchemaGuide): { from: number; to: number; text: string } | null {
  const root = parseJsonc(text);
  const document = plain(root);
  const { path, node, key } = locate(root, position);
  if (key) {
    const schema = guide.members(path, document).get(key.key);
    const found = schema && summary(schema);
    return found ? { from: key.keyFrom, to: key.keyTo, text: found } : null;
  }
  if (path.at(-1) !== "type" || node.kind !== "string") return null;
  const owner = path.slice(0, -1);
  const description = nodeAt(root, owner) && guide.at(owner, document)[0]?.description;
  return description ? { from: node.from, to: node.to, text: description } : null;
}

export const hover = (guide: () => SchemaGuide | null) =>
  hoverTooltip((view, position) => {
    const known = guide();
    const found = known && describe(view.state.doc.toString(), position, known);
    if (!found) return null;
    const create = () => {
      const dom = document.createElement("div");
      dom.className = "schema-hover";
      dom.textContent = found.text;
      return { dom };
    };
    return { pos: found.from, end: found.to, above: true, create };
  });
