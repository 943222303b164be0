import { describe, expect, it } from "vitest";
import { Text } from "@codemirror/state";
import { fingerprint } from "../src/editor/sync";
import { mergedChange } from "../src/editor/unsent";

const merged = (base: string, text: string, current: string, passed = [base], isWhole = false) =>
  mergedChange({ name: "a.json", path: null, time: "", base, text, passed: passed.map(fingerprint) }, current, isWhole).apply(Text.of(current.split("\n"))).toString();

describe("text that was typed while the server was gone", () => {
  it("is put where it was typed", () => expect(merged("a b c", "a typed b c", "a b c")).toBe("a typed b c"));
  it("moves past what has changed before it", () => expect(merged("a b c", "a b typed c", "new a b c")).toBe("new a b typed c"));
  it("keeps what has changed behind it", () => expect(merged("a b c", "typed a b c", "a b new c")).toBe("typed a b new c"));
  it("is whole where the server's end has taken some of what it had", () =>
    expect(merged("// one a b c", "// one two\na b c", "// a b c", ["// a b c", "// one a b c"])).toBe("// one two\na b c"));
  it("takes the place of another text where that is wanted", () => expect(merged("a", "a typed", "new", [], true)).toBe("a typed"));
  it("changes nothing where nothing was typed", () => expect(merged("a", "a", "b")).toBe("b"));
});
