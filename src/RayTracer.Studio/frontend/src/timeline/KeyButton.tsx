import { post } from "../api/client";
import type { CatalogueParameter, Json } from "../api/types";
import { kindOf } from "../panel/types";
import { attempt } from "../state/messages";
import { time } from "../state/store";
import { texts } from "../texts";
import { Button } from "../ui/Button";
import { animatedAt } from "./atTime";

const t = texts.timeline;
const numeric = new Set(["number", "integer", "vector2", "vector3", "color"]);

/** Whether keys can hold a value: numbers, vectors and colours. */
export function canBeAnimated(parameter: CatalogueParameter, effective: Json | undefined): boolean {
  if (effective === null || effective === undefined) return false;
  if (numeric.has(kindOf(parameter))) return true;
  return kindOf(parameter) === "texture" && (typeof effective === "number" || Array.isArray(effective) || (typeof effective === "string" && effective.startsWith("#")));
}

interface KeyButtonProps {
  pointer: string;
  label: string;
}

/** Sets a key of a value at the frame that is shown, or removes the one that is there. */
export function KeyButton({ pointer, label }: KeyButtonProps) {
  const parts = animatedAt(pointer, time.value?.values ?? []);
  const frame = time.value?.frame ?? 0;
  const hasKey = parts.some((p) => p.hasKey);
  const toggle = () =>
    attempt(async () => {
      for (const part of parts.length > 0 ? parts.map((p) => p.pointer) : [pointer]) await post("timeline/key", { pointer: part });
    });
  return (
    <span class={`key-button ${parts.length > 0 ? "animated" : ""}`}>
      <Button label={hasKey ? t.removeKey(label, frame) : t.setKey(label, frame)} tip={t.keyWhy} icon={hasKey ? "keySet" : "key"} pressed={hasKey} onClick={toggle} />
    </span>
  );
}
