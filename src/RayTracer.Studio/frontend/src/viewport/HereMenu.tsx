import { signal } from "@preact/signals";
import { get } from "../api/client";
import type { PickResult } from "../api/types";
import { addItems } from "../files/add";
import { join } from "../json/pointer";
import type { Point } from "../math/projection";
import { commandItem, type CommandId } from "../state/commands";
import { applyTo, isSeen, select, type Pixel } from "../state/edits";
import { attempt } from "../state/messages";
import { outline, selected } from "../state/store";
import { texts } from "../texts";
import { MenuList, type MenuItem } from "../ui/Menu";

const t = texts.viewport;
const ofThings: CommandId[] = ["frame", "rename", "duplicate", "delete", "hide", "lock"];

/** Where the menu is open: in the window, and in the picture. */
const openAt = signal<{ x: number; y: number; pixel: Pixel; thing: string | null } | null>(null);

/** Opens the menu of what can be done at a pixel; what is seen there is selected. */
export function openHere(window: Point, pixel: Point): void {
  attempt(async () => {
    const { pointer } = await get<PickResult>("pick", { x: pixel.x, y: pixel.y });
    if (pointer && !selected.value?.includes(pointer)) select(pointer);
    openAt.value = { ...window, pixel: [pixel.x, pixel.y], thing: pointer };
  });
}

/** What can be done where one has clicked with the right button, or in the middle of the picture by key. */
export function HereMenu() {
  const at = openAt.value;
  if (!at) return null;
  const { pixel, thing } = at;
  const given = (list: "materials" | "textures"): MenuItem[] => {
    const items = (outline.value?.[list] ?? []).map(({ name }) => ({ label: name, run: () => applyTo(join(`/${list}`, name), { at: pixel }) }));
    return items.length > 0 ? [{ label: texts.outliner[list], items }] : [];
  };
  const items = [
    ...["shape", "light"].map((family) => ({ label: t.addHere(texts.families[family]!), items: addItems(family, pixel) })),
    ...(isSeen(thing) ? [...given("materials"), ...given("textures"), ...ofThings.map(commandItem)] : []),
  ];
  const close = (returnsFocus: boolean) => {
    openAt.value = null;
    if (returnsFocus) document.querySelector<HTMLElement>(".stage")?.focus();
  };
  return <div data-handle="menu"><MenuList label={t.here} items={items} close={close} at={at} key={`${at.x},${at.y}`} /></div>;
}
