import type { CatalogueType, Json } from "../api/types";
import { chooseFile } from "../files/choose";
import { setValue } from "../state/edits";
import { kindOf, retyped } from "./types";

/** Puts another type in place of this one. Where that cannot be without a file, it is asked for first: until then, and without one, all stays as it is, and false is returned. */
export function retype(pointer: string, value: Json | undefined, type: CatalogueType, before: CatalogueType | null, family: string | null = null): boolean {
  const result = retyped(value, type, before, family);
  const file = type.parameters.find((p) => p.required && kindOf(p) === "file" && !result[p.key]);
  if (file) chooseFile((path) => setValue(pointer, { ...result, [file.key]: path }));
  else setValue(pointer, result);
  return !file;
}
