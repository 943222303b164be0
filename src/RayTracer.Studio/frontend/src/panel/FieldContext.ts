import type { Json, CatalogueParameter } from "../api/types";

/** What every editor of a parameter is given. */
export interface FieldProps {
  parameter: CatalogueParameter;
  pointer: string;
  /** As written; undefined where the default counts. */
  value: Json | undefined;
  /** As it counts: the written value or the default. */
  effective: Json;
  label: string;
  id: string;
}
