import { signal } from "@preact/signals";
import { useRef } from "preact/hooks";
import type { OutlineNode } from "../api/types";
import { contains } from "../json/pointer";
import { askForName, duplicate, isThing, remove, select } from "../state/edits";
import { rightOpen, rightTab } from "../state/settings";
import { outline, selection } from "../state/store";
import { texts } from "../texts";
import { Icon, type IconName } from "../ui/Icon";
import { filterNodes } from "./find";

const filter = signal("");
const closed = signal<ReadonlySet<string>>(new Set());

const icons: Record<string, IconName> = { shapes: "sphere", lights: "light", materials: "material", textures: "texture" };
const ownTabs: Record<string, string> = { "/camera": "camera", "/render": "render", "/background": "world" };

function toggle(key: string): void {
  const next = new Set(closed.value);
  if (!next.delete(key)) next.add(key);
  closed.value = next;
}

function choose(node: OutlineNode): void {
  select(node.pointer);
  rightTab.value = ownTabs[node.pointer] ?? "object";
}

interface NodeProps {
  node: OutlineNode;
  icon: IconName;
  level: number;
  isFirst: boolean;
}

function TreeNode({ node, icon, level, isFirst }: NodeProps) {
  const isSelected = selection.value === node.pointer;
  const children = node.children ?? [];
  const isOpen = !closed.value.has(node.pointer);
  const isReachable = isSelected || (isFirst && selection.value === null);
  const onClick = (e: MouseEvent) => {
    e.stopPropagation();
    choose(node);
  };
  return (
    <li
      role="treeitem"
      aria-label={`${node.name}${node.type && node.type !== node.name ? `, ${node.type}` : ""}${node.isLight ? `, ${texts.outliner.shines}` : ""}`}
      aria-selected={isSelected}
      aria-expanded={children.length ? isOpen : undefined}
      aria-level={level}
      tabIndex={isReachable ? 0 : -1}
      data-pointer={node.pointer}
      onClick={onClick}
      onDblClick={() => (rightOpen.value = true)}
    >
      <div class="node" style={{ paddingInlineStart: `${level * 0.75}rem` }} data-tip={node.summary || undefined}>
        {children.length > 0 && (
          <span class={`twist ${isOpen ? "open" : ""}`} aria-hidden="true" onClick={(e) => (e.stopPropagation(), toggle(node.pointer))}><Icon name="chevron" /></span>
        )}
        {node.color ? <span class="swatch" style={{ background: node.color }} /> : <Icon name={node.isLight ? "light" : icon} />}
        <span class="name">{node.name}</span>
        {node.type !== node.name && <span class="type">{node.type}</span>}
      </div>
      {children.length > 0 && isOpen && (
        <ul role="group">{children.map((child) => <TreeNode node={child} icon={icon} level={level + 1} isFirst={false} key={child.pointer} />)}</ul>
      )}
    </li>
  );
}

/** The tree of all things; arrows move in it as the ARIA pattern says. */
export function Outliner() {
  const root = useRef<HTMLUListElement>(null);
  const all = outline.value;
  if (!all) return null;

  const single: [OutlineNode | null, IconName][] = [[all.camera, "camera"], [all.render, "render"], [all.background, "background"]];
  const groups = (["shapes", "lights", "materials", "textures"] as const).map((key) => ({ key, nodes: filterNodes(all[key] ?? [], filter.value) }));
  const isEmpty = filter.value && groups.every((g) => g.nodes.length === 0);

  const onKeyDown = (e: KeyboardEvent) => {
    const items = [...(root.current?.querySelectorAll<HTMLElement>("[role=treeitem]") ?? [])];
    const item = document.activeElement as HTMLElement;
    const here = items.indexOf(item);
    if (here < 0) return;
    const pointer = item.dataset.pointer ?? "";
    const expanded = item.getAttribute("aria-expanded");
    const moves: Record<string, number> = { ArrowDown: here + 1, ArrowUp: here - 1, Home: 0, End: items.length - 1 };
    const target = moves[e.key];
    if (target !== undefined) items[target]?.focus();
    else if (e.key === "Enter" || e.key === " ") item.click();
    else if (e.key === "ArrowRight" && expanded === "false") toggle(pointer);
    else if (e.key === "ArrowRight" && expanded === "true") items[here + 1]?.focus();
    else if (e.key === "ArrowLeft" && expanded === "true") toggle(pointer);
    else if (e.key === "ArrowLeft") items.find((i) => i !== item && i.contains(item))?.focus();
    else if (e.key === "Delete" && isThing(pointer)) remove(pointer);
    else if (e.key === "F2" && pointer === selection.value) askForName();
    else if (e.key === "d" && e.ctrlKey && isThing(pointer)) duplicate(pointer);
    else return;
    e.preventDefault();
    e.stopPropagation();
  };

  return (
    <div class="outliner">
      <input type="search" class="text" aria-label={texts.outliner.filter} placeholder={texts.outliner.filter} value={filter.value} onInput={(e) => (filter.value = e.currentTarget.value)} />
      <ul role="tree" aria-label={texts.outliner.label} ref={root} onKeyDown={onKeyDown}>
        {!filter.value && single.map(([node, icon], i) => node && <TreeNode node={node} icon={icon} level={1} isFirst={i === 0} key={node.pointer} />)}
        {groups.map(({ key, nodes }) => {
          if (filter.value && nodes.length === 0) return null;
          const isOpen = !closed.value.has(`/${key}`) || nodes.some((n) => selection.value && contains(n.pointer, selection.value));
          return (
            <li role="treeitem" aria-label={texts.outliner[key]} aria-expanded={isOpen} aria-selected={false} aria-level={1} tabIndex={-1} data-pointer={`/${key}`} key={key} onClick={() => toggle(`/${key}`)}>
              <div class="node heading">
                <span class={`twist ${isOpen ? "open" : ""}`} aria-hidden="true"><Icon name="chevron" /></span>
                <span class="name">{texts.outliner[key]}</span>
                <span class="type">{nodes.length || texts.outliner.empty}</span>
              </div>
              {isOpen && <ul role="group">{nodes.map((n) => <TreeNode node={n} icon={icons[key]!} level={2} isFirst={false} key={n.pointer} />)}</ul>}
            </li>
          );
        })}
      </ul>
      {isEmpty && <p class="quiet pad">{texts.outliner.nothingFound}</p>}
    </div>
  );
}
