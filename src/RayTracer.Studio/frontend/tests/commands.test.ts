import { readdirSync, readFileSync } from "node:fs";
import { beforeAll, describe, expect, test } from "vitest";
import type { Command } from "../src/state/commands";
import { languages, texts } from "../src/texts";
import { pretendBrowser } from "./browser";

let commands: Record<string, Command>;
let commandOf: typeof import("../src/state/shortcuts").commandOf;

beforeAll(async () => {
  pretendBrowser();
  commands = (await import("../src/state/commands")).commands;
  commandOf = (await import("../src/state/shortcuts")).commandOf;
});

const press = (key: string, modifiers: string[] = []) => ({
  key, ctrlKey: modifiers.includes("Mod"), metaKey: false, shiftKey: modifiers.includes("Shift"), altKey: modifiers.includes("Alt"),
});

describe("keyboard shortcuts", () => {
  test("lead to their commands, each to one", () => {
    for (const [id, { keys }] of Object.entries(commands)) {
      if (!keys) continue;
      const parts = keys.split("+");
      expect(commandOf(press(parts.at(-1)!, parts.slice(0, -1)))).toBe(id);
    }
  });

  test("are found with capital letters, and question marks with Shift", () => {
    expect(commandOf(press("Z", ["Mod", "Shift"]))).toBe("redo");
    expect(commandOf(press("?", ["Shift"]))).toBe("shortcuts");
    expect(commandOf(press("z"))).toBe("alongZ");
    expect(commandOf(press("x", ["Mod"]))).toBeNull();
  });
});

/** All texts of an object with the places where they stand. */
function flat(value: unknown, place = ""): [string, unknown][] {
  if (value === null || typeof value !== "object") return [[place, value]];
  return Object.entries(value).flatMap(([key, inner]) => flat(inner, `${place}/${key}`));
}

describe("the texts", () => {
  test("are the same ones in every language, none of them empty", () => {
    const places = flat(texts).map(([place]) => place);
    for (const language of Object.values(languages)) {
      expect(flat(language).map(([place]) => place)).toEqual(places);
      for (const [place, text] of flat(language)) expect(typeof text === "function" || (text as string).trim(), place).toBeTruthy();
    }
  });

  test("name and explain every command", () => {
    expect(Object.keys(commands).sort()).toEqual(Object.keys(texts.commands).sort());
    for (const { group } of Object.values(commands)) expect(texts.groups).toHaveProperty(group);
  });

  test("are the only ones: no component writes one of its own", () => {
    const folder = new URL("../src/", import.meta.url);
    const files = readdirSync(folder, { recursive: true }).map(String).filter((f) => f.endsWith(".tsx"));
    expect(files.length).toBeGreaterThan(20);
    for (const file of files) {
      const source = readFileSync(new URL(file, folder), "utf8");
      const written = [...source.matchAll(/(?:aria-label|label|title|placeholder|alt|tip)="([^"]+)"|<(?:p|span|h\d|strong|button)[^<>{}]*>([^<>{}]*[a-z]{3}[^<>{}]*)</g)];
      expect(written.map((m) => m[0]), file).toEqual([]);
    }
  });

  test("are all used", () => {
    const folder = new URL("../src/", import.meta.url);
    const sources = readdirSync(folder, { recursive: true }).map(String).filter((f) => /\.tsx?$/.test(f) && f !== "texts.ts").map((f) => readFileSync(new URL(f, folder), "utf8")).join("\n");
    const unused: string[] = [];
    for (const [section, members] of Object.entries(texts)) {
      if (typeof members !== "object" || ["commands", "maps", "groups", "formats", "families", "theme", "desktop", "idle"].includes(section)) continue;
      for (const key of Object.keys(members)) if (!new RegExp(`\\b${key}\\b`).test(sources)) unused.push(`${section}.${key}`);
    }
    expect(unused).toEqual([]);
  });
});
