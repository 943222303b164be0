import type { CatalogueType } from "../api/types";
import { kindOf, spaced } from "../panel/types";
import { addThing, type Pixel } from "../state/edits";
import { rightTab } from "../state/settings";
import { outline, schema } from "../state/store";
import type { MenuItem } from "../ui/Menu";
import { chooseFile } from "./choose";

/** Adds a thing to the scene, at a pixel of the picture or where one looks; one that cannot be without a file asks for it first, and returns false. */
export function add(family: string, type: CatalogueType, at?: Pixel): boolean {
  const put = (file?: string) => {
    rightTab.value = family === "environment" ? "world" : "object";
    addThing(family, type.name, file, at);
  };
  const needsFile = type.parameters.some((p) => p.required && kindOf(p) === "file");
  if (needsFile) chooseFile(put);
  else put();
  return !needsFile;
}

/** What can be added of a family, as items of a menu. */
export function addItems(family: string, at?: Pixel): MenuItem[] {
  const all = Object.values(schema.value?.types ?? {}).flat();
  const isPossible = (type: CatalogueType) => !!outline.value?.objects.length || !type.parameters.some((p) => p.required && p.kind === "shape");
  return all
    .filter((type) => type.addedAs.includes(family) && isPossible(type))
    .sort((a, b) => a.addedAs.length - b.addedAs.length)
    .map((type) => ({ label: spaced(type.name), tip: type.summary, run: () => void add(family, type, at) }));
}
