import { get } from "../api/client";
import type { PropertyValues } from "../api/types";
import { attempt } from "../state/messages";
import { bottomOpen, bottomTab } from "../state/settings";
import { wantedPlace } from "../state/store";

/** Opens the source at a range of characters. */
export function showRange(from: number, to: number): void {
  bottomOpen.value = true;
  bottomTab.value = "source";
  wantedPlace.value = { from, to };
}

/** Opens the source where a thing is written. */
export const showInSource = (pointer: string) =>
  attempt(async () => {
    const { from, to } = await get<PropertyValues>("value", { pointer });
    showRange(from, to);
  });
