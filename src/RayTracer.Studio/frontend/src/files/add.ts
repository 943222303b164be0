import type { CatalogueType } from "../api/types";
import { kindOf } from "../panel/types";
import { addThing } from "../state/edits";
import { rightTab } from "../state/settings";
import { documentState } from "../state/store";
import { chooseFile } from "./choose";
import { relativeTo } from "./paths";

/** Adds a thing to the scene; one that cannot be without a file asks for it first. */
export function add(family: string, type: CatalogueType): void {
  const put = (file?: string) => {
    rightTab.value = family === "environment" ? "world" : "object";
    addThing(family, type.name, file);
  };
  const needsFile = type.parameters.some((p) => p.required && kindOf(p) === "file");
  if (needsFile) chooseFile((path) => put(relativeTo(documentState.value?.path ?? null, path)));
  else put();
}
