import { signal } from "@preact/signals";
import { useRef } from "preact/hooks";
import { parent } from "../json/pointer";
import { applyTo, askForName, duplicate, isGiven, isSeen, isThing, remove, select, toggleHidden, toggleLocked } from "../state/edits";
import { rightOpen, rightTab } from "../state/settings";
import { hidden, locked, outline, selected, selection } from "../state/store";
import { texts } from "../texts";
import { Icon, type IconName } from "../ui/Icon";
import { draggedThing, dragThing, droppedThing } from "./drag";
import { rowsOf, type Row } from "./rows";

const filter = signal("");
const closed = signal<ReadonlySet<string>>(new Set());

/** The section chosen last, while nothing else is selected. */
const chosenSection = signal<string | null>(null);

const icons: Record<Row["kind"], IconName> = {
  camera: "camera", render: "render", background: "background", environment: "background", ambient: "light",
  shapes: "sphere", lights: "light", materials: "material", textures: "texture", objects: "scene",
};
const ownTabs: Partial<Record<Row["kind"], string>> = { camera: "camera", render: "render", background: "world", environment: "world", ambient: "world" };

function toggle(pointer: string): void {
  const next = new Set(closed.value);
  if (!next.delete(pointer)) next.add(pointer);
  closed.value = next;
}

// What has a tab of its own may not be written in the text at all, and needs no selection.
function choose(row: Row, adds: boolean): void {
  if (row.isHeading) return toggle(row.pointer);
  const tab = ownTabs[row.kind];
  select(tab ? null : row.pointer, adds && !tab);
  chosenSection.value = tab ? row.pointer : null;
  rightTab.value = tab ?? "object";
}

/** What a key does to a row is done to all selected ones with it. */
const together = (pointer: string) => (selected.value?.includes(pointer) ? selected.value.filter(isThing) : [pointer]);

const isChosen = (row: Row) =>
  !row.isHeading && (selected.value?.includes(row.pointer) || (selection.value === null && chosenSection.value === row.pointer));

function RowName({ row }: { row: Row }) {
  const { node, kind, count } = row;
  const isSection = kind in ownTabs;
  if (!node || isSection) {
    return (
      <>
        {isSection && (node?.color ? <span class="swatch" style={{ background: node.color }} /> : <Icon name={icons[kind]} />)}
        <span class="name">{texts.outliner[kind]}</span>
        {kind === "environment" && <span class="type">{node?.summary}</span>}
        {row.isHeading && <span class="type">{count || texts.outliner.empty}</span>}
      </>
    );
  }
  return (
    <>
      {node.color ? <span class="swatch" style={{ background: node.color }} /> : <Icon name={icons[kind]} />}
      <span class="name">{node.name}</span>
      {node.isLight && kind !== "lights" && <span class="type">{texts.outliner.shines}</span>}
      <span class="type">{node.type}</span>
    </>
  );
}

/** Whether a thing is hidden and locked, to be clicked; by keyboard, H and L do the same with what is selected. */
function Marks({ row: { pointer, node } }: { row: Row }) {
  if (!node || !isSeen(pointer)) return null;
  const [isHidden, isLocked] = [hidden.value?.includes(pointer), locked.value?.includes(pointer)];
  const mark = (icon: IconName, isOn: boolean | undefined, state: string, label: string, toggle: (pointers: string[]) => void) => (
    <span class={`mark ${isOn ? "on" : ""}`} role="img" aria-label={isOn ? state : undefined} aria-hidden={!isOn} data-tip={label} onClick={(e) => (e.stopPropagation(), toggle([pointer]))} onDblClick={(e) => e.stopPropagation()}><Icon name={icon} /></span>
  );
  const t = texts.outliner;
  return (
    <span class="marks">
      {mark(isHidden ? "eyeOff" : "eye", isHidden, t.hidden, isHidden ? t.show(node.name) : t.hide(node.name), toggleHidden)}
      {mark(isLocked ? "lock" : "unlock", isLocked, t.locked, isLocked ? t.unlock(node.name) : t.lock(node.name), toggleLocked)}
    </span>
  );
}

interface TreeRowProps {
  row: Row;
  isReachable: boolean;
}

function TreeRow({ row, isReachable }: TreeRowProps) {
  const { isOpen, pointer, node, isHeading, level } = row;
  const takes = !isHeading && /^\/(shapes|materials)\//.test(pointer);
  const onDrop = (e: DragEvent) => {
    const given = droppedThing(e);
    if (!takes || !given || given === pointer) return;
    e.preventDefault();
    applyTo(given, { things: [pointer] });
  };
  return (
    <div
      role="treeitem"
      class={`node ${isHeading ? "heading" : ""} ${hidden.value?.includes(pointer) ? "hidden-thing" : ""}`}
      draggable={isGiven(pointer)}
      onDragStart={(e) => dragThing(e, pointer)}
      onDragOver={(e) => takes && draggedThing(e) && e.preventDefault()}
      onDrop={onDrop}
      aria-selected={isChosen(row)}
      aria-expanded={isOpen ?? undefined}
      aria-level={level}
      tabIndex={isReachable ? 0 : -1}
      data-pointer={pointer}
      data-help={node?.type ? `scene-format#${node.type}` : undefined}
      data-tip={node?.summary || undefined}
      style={{ paddingInlineStart: isHeading ? "0.125rem" : `${level * 0.75 - 0.375}rem` }}
      onClick={(e) => choose(row, e.ctrlKey || e.metaKey || e.shiftKey)}
      onDblClick={() => (rightOpen.value = true)}
    >
      {isOpen !== null && (
        <span class={`twist ${isOpen ? "open" : ""}`} aria-hidden="true" onClick={(e) => (e.stopPropagation(), toggle(pointer))}><Icon name="chevron" /></span>
      )}
      <RowName row={row} />
      <Marks row={row} />
    </div>
  );
}

/** The tree of all things; arrows move in it as the ARIA pattern says. */
export function Outliner() {
  const root = useRef<HTMLDivElement>(null);
  if (!outline.value) return null;
  const rows = rowsOf(outline.value, closed.value, filter.value);
  const reachable = rows.find(isChosen) ?? rows[0];

  const onKeyDown = (e: KeyboardEvent) => {
    const items = [...(root.current?.querySelectorAll<HTMLElement>("[role=treeitem]") ?? [])];
    const here = items.indexOf(document.activeElement as HTMLElement);
    const row = rows[here];
    if (!row) return;
    const { pointer, isOpen } = row;
    const outside = rows.findIndex((r) => r.pointer === parent(pointer) || r.pointer === parent(parent(pointer)));
    const moves: Record<string, number> = { ArrowDown: here + 1, ArrowUp: here - 1, Home: 0, End: items.length - 1 };
    const target = moves[e.key];
    if (target !== undefined) items[target]?.focus();
    else if (e.key === "Enter" || e.key === " ") choose(row, e.ctrlKey || e.metaKey);
    else if (e.key === "ArrowRight" && isOpen === false) toggle(pointer);
    else if (e.key === "ArrowRight") items[here + (isOpen ? 1 : 0)]?.focus();
    else if (e.key === "ArrowLeft" && isOpen) toggle(pointer);
    else if (e.key === "ArrowLeft") items[outside]?.focus();
    else if (e.key === "Delete" && isThing(pointer)) remove(together(pointer));
    else if (e.key === "F2" && pointer === selection.value) askForName();
    else if (e.key === "d" && e.ctrlKey && isThing(pointer)) duplicate(together(pointer));
    else return;
    e.preventDefault();
    e.stopPropagation();
  };

  return (
    <div class="outliner">
      <input type="search" class="text" aria-label={texts.outliner.filter} placeholder={texts.outliner.filter} value={filter.value} onInput={(e) => (filter.value = e.currentTarget.value)} />
      <div role="tree" aria-multiselectable="true" aria-label={texts.outliner.label} ref={root} onKeyDown={onKeyDown}>
        {rows.map((row) => <TreeRow row={row} isReachable={row === reachable} key={row.pointer} />)}
      </div>
      {rows.length === 0 && <p class="quiet pad">{texts.outliner.nothingFound}</p>}
    </div>
  );
}
