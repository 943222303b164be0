/** How scene files look in the editor: JSON with comments, read token by token, so that a text with errors looks as well as one without. */

import { foldService, HighlightStyle, indentService, StreamLanguage, syntaxHighlighting } from "@codemirror/language";
import { tags } from "@lezer/highlight";

interface State {
  inComment: boolean;
}

export const jsonc = StreamLanguage.define<State>({
  name: "jsonc",
  startState: () => ({ inComment: false }),
  copyState: (s) => ({ ...s }),
  token(stream, state) {
    if (state.inComment || stream.match("/*")) {
      state.inComment = !stream.match(/^.*?\*\//);
      if (state.inComment) stream.skipToEnd();
      return "comment";
    }
    if (stream.eatSpace()) return null;
    if (stream.match(/^\/\/.*/)) return "comment";
    if (stream.match(/^"(?:[^"\\]|\\.)*"?/)) return stream.match(/^\s*:/, false) ? "propertyName" : "string";
    if (stream.match(/^-?\d[\d.eE+-]*/)) return "number";
    if (stream.match(/^(true|false|null)\b/)) return "bool";
    const bracket = stream.match(/^[{}[\]]/);
    if (!bracket) stream.next();
    return bracket ? "bracket" : "punctuation";
  },
  languageData: { commentTokens: { line: "//", block: { open: "/*", close: "*/" } }, closeBrackets: { brackets: ["[", "{", '"'] } },
});

export const highlighting = syntaxHighlighting(HighlightStyle.define([
  { tag: tags.propertyName, color: "var(--code-key)" },
  { tag: tags.string, color: "var(--code-string)" },
  { tag: tags.number, color: "var(--code-number)" },
  { tag: tags.bool, color: "var(--code-word)" },
  { tag: tags.comment, color: "var(--code-comment)", fontStyle: "italic" },
  { tag: [tags.bracket, tags.punctuation], color: "var(--text-quiet)" },
]));

/** A line that opens a bracket can be folded up to the line that is indented as it is. */
export const folding = foldService.of((state, from, lineEnd) => {
  const line = state.doc.lineAt(from);
  if (!/[[{]\s*(\/\/.*)?$/.test(line.text)) return null;
  const indent = /^\s*/.exec(line.text)![0].length;
  for (let n = line.number + 1; n <= state.doc.lines; n++) {
    const next = state.doc.line(n);
    if (next.text.trim() && /^\s*/.exec(next.text)![0].length <= indent) return n > line.number + 1 ? { from: lineEnd, to: state.doc.line(n - 1).to } : null;
  }
  return null;
});

/** A new line is indented as the one before, and deeper behind an open bracket. */
export const indentation = indentService.of((context, position) => {
  const line = context.lineAt(position);
  const before = line.from > 0 ? context.lineAt(line.from - 1) : null;
  if (!before) return 0;
  const opens = /[[{]\s*(\/\/.*)?$/.test(before.text) ? context.unit : 0;
  const closes = /^\s*[\]}]/.test(line.text) ? context.unit : 0;
  return Math.max(0, context.lineIndent(before.from) + opens - closes);
});
