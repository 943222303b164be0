/** A tolerant parser of JSON with comments: for a text that is just being typed, it gives each value's place. */

export interface JsonNode {
  kind: "object" | "array" | "string" | "number" | "word" | "missing";
  from: number;
  to: number;
  members: JsonMember[];
  items: JsonNode[];
  /** Of strings, numbers and words. */
  value?: unknown;
}

export interface JsonMember {
  key: string;
  keyFrom: number;
  keyTo: number;
  value: JsonNode;
}

const literals: Record<string, unknown> = { true: true, false: false, null: null };
const token = /\s+|\/\/[^\n]*|\/\*[^]*?(?:\*\/|$)|"(?:[^"\\\n]|\\.)*"?|[-+.\w]+|[^]/gy;

interface Token {
  text: string;
  from: number;
  to: number;
}

function tokens(text: string): Token[] {
  const result: Token[] = [];
  for (const match of text.matchAll(token)) {
    if (!/^(\s|\/\/|\/\*)/.test(match[0])) result.push({ text: match[0], from: match.index, to: match.index + match[0].length });
  }
  return result;
}

/** Whether a position is within a comment, or at the end of one that a line ends. */
export function isInComment(text: string, position: number): boolean {
  for (const match of text.matchAll(token)) {
    const end = match.index + match[0].length;
    if (/^\/[/*]/.test(match[0]) && position > match.index && (position < end || (position === end && !match[0].endsWith("*/")))) return true;
    if (match.index >= position) break;
  }
  return false;
}

function unquote(text: string): string {
  try {
    return JSON.parse(text) as string;
  } catch {
    return text.replace(/^"|"$/g, "");
  }
}

/** The root value. What is wrong is skipped; nothing is reported, the server does that. */
export function parseJsonc(text: string): JsonNode {
  const all = tokens(text);
  let next = 0;
  const at = () => all[next];
  const leaf = (kind: JsonNode["kind"], from: number, to: number, value?: unknown): JsonNode => ({ kind, from, to, members: [], items: [], value });

  function value(): JsonNode {
    const t = at();
    if (!t || /^[}\],:]$/.test(t.text)) return leaf("missing", t?.from ?? text.length, t?.from ?? text.length);
    if (t.text === "{") return object();
    if (t.text === "[") return array();
    next++;
    if (t.text.startsWith('"')) return leaf("string", t.from, t.to, unquote(t.text));
    if (t.text in literals) return leaf("word", t.from, t.to, literals[t.text]);
    return Number.isNaN(Number(t.text)) ? leaf("word", t.from, t.to) : leaf("number", t.from, t.to, Number(t.text));
  }

  function object(): JsonNode {
    const node = leaf("object", at()!.from, text.length);
    next++;
    for (let t = at(); t; t = at()) {
      if (t.text === "}") {
        node.to = t.to;
        next++;
        break;
      }
      // A bracket that closes something around this object.
      if (t.text === "]") {
        node.to = t.from;
        break;
      }
      next++;
      if (!t.text.startsWith('"')) continue;
      const hasColon = at()?.text === ":";
      if (hasColon) next++;
      const own = hasColon ? value() : leaf("missing", t.to, t.to);
      node.members.push({ key: unquote(t.text), keyFrom: t.from, keyTo: t.to, value: own });
    }
    return node;
  }

  function array(): JsonNode {
    const node = leaf("array", at()!.from, text.length);
    next++;
    for (let t = at(); t; t = at()) {
      if (t.text === "]") {
        node.to = t.to;
        next++;
        break;
      }
      if (t.text === "}") {
        node.to = t.from;
        break;
      }
      if (t.text === "," || t.text === ":") next++;
      else node.items.push(value());
    }
    return node;
  }

  return value();
}

export interface Location {
  /** Keys from the root to the object or value that the position is in. */
  path: (string | number)[];
  /** The innermost object or array, or the value itself. */
  node: JsonNode;
  /** The member whose key the position is in. */
  key: JsonMember | null;
}

/** What the position is in. */
export function locate(root: JsonNode, position: number): Location {
  const path: (string | number)[] = [];
  let node = root;
  for (;;) {
    const member = node.members.find((m) => position >= m.keyFrom && position <= Math.max(m.keyTo, m.value.to));
    if (member && position <= member.keyTo) return { path, node, key: member };
    const item = node.items.findIndex((i) => position >= i.from && position <= i.to);
    const inner = member?.value ?? node.items[item];
    if (!inner || (member && position < inner.from && inner.kind !== "missing")) return member ? { path: [...path, member.key], node: member.value, key: null } : { path, node, key: null };
    path.push(member?.key ?? item);
    if ((inner.kind === "object" || inner.kind === "array") && position > inner.from && position < Math.max(inner.to, inner.from + 1) + (isClosed(inner) ? 0 : 1)) node = inner;
    else return { path, node: inner, key: null };
  }
}

// What ends with the text was never closed, and goes on at its end.
const isClosed = (node: JsonNode) => node.members.every((m) => m.value.to < node.to) && node.items.every((i) => i.to < node.to);

/** The value as plain data; what is missing is left out. */
export function plain(node: JsonNode): unknown {
  if (node.kind === "object") return Object.fromEntries(node.members.map((m) => [m.key, plain(m.value)]));
  if (node.kind === "array") return node.items.map(plain);
  return node.value;
}

/** The node at a path; null where there is none. */
export function nodeAt(root: JsonNode, path: readonly (string | number)[]): JsonNode | null {
  let node: JsonNode | undefined = root;
  for (const key of path) node = typeof key === "number" ? node?.items[key] : node?.members.find((m) => m.key === key)?.value;
  return node ?? null;
}
