import { describe, expect, it } from "vitest";
import { Text } from "@codemirror/state";
import { mergedChange } from "../src/editor/unsent";

const merged = (base: string, text: string, current: string) =>
  mergedChange({ name: "a.json", time: "", base, text }, current).apply(Text.of(current.split("\n"))).toString();

describe("text that was typed while the server was gone", () => {
  it("is put where it was typed", () => expect(merged("a b c", "a typed b c", "a b c")).toBe("a typed b c"));
  it("moves past what has changed before it", () => expect(merged("a b c", "a b typed c", "new a b c")).toBe("new a b typed c"));
  it("keeps what has changed behind it", () => expect(merged("a b c", "typed a b c", "a b new c")).toBe("typed a b new c"));
  it("changes nothing where nothing was typed", () => expect(merged("a", "a", "b")).toBe("b"));
});
