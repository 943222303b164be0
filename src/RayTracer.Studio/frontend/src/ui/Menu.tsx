import { useLayoutEffect, useRef, useState } from "preact/hooks";
import { Icon, type IconName } from "./Icon";

export interface MenuItem {
  label: string;
  /** What it is called where its group is not seen. */
  name?: string | undefined;
  run: () => void;
  tip?: string | undefined;
  keys?: string | undefined;
  disabled?: boolean | undefined;
  /** Items of another group stand below a line; its name is read before them. */
  group?: string | undefined;
}

interface MenuProps {
  label: string;
  items: MenuItem[];
  icon?: IconName;
  tip?: string;
  showLabel?: boolean;
}

interface MenuListProps {
  label: string;
  items: MenuItem[];
  /** Called when it shall close: with true if the focus shall go back to where it was. */
  close: (returnsFocus: boolean) => void;
  /** Where it stands in the window; null for below its button. */
  at?: { x: number; y: number };
}

/** A list of commands; arrow keys, Home, End and letters move in it. */
export function MenuList({ label, items, close, at }: MenuListProps) {
  const root = useRef<HTMLDivElement>(null);
  const buttons = () => [...(root.current?.querySelectorAll<HTMLElement>("[role=menuitem]") ?? [])];

  // A layout effect, so that the next key finds the focus in the menu, or not there any more.
  useLayoutEffect(() => {
    const list = root.current!;
    if (at) {
      list.style.left = `${Math.max(0, Math.min(at.x, innerWidth - list.offsetWidth - 4))}px`;
      list.style.top = `${Math.max(0, Math.min(at.y, innerHeight - list.offsetHeight - 4))}px`;
    }
    buttons()[0]?.focus();
    const outside = (e: PointerEvent) => list.parentElement!.contains(e.target as Node) || close(false);
    document.addEventListener("pointerdown", outside);
    return () => document.removeEventListener("pointerdown", outside);
  }, []);

  const onKeyDown = (e: KeyboardEvent) => {
    const all = buttons();
    const here = all.indexOf(document.activeElement as HTMLElement);
    const letter = e.key.length === 1 ? all.findIndex((b, i) => i > here && b.textContent?.toLowerCase().startsWith(e.key.toLowerCase())) : -1;
    const targets: Record<string, number> = { ArrowDown: (here + 1) % all.length, ArrowUp: (here - 1 + all.length) % all.length, Home: 0, End: all.length - 1 };
    const target = targets[e.key] ?? letter;
    if (e.key === "Escape") close(true);
    else if (e.key === "Tab") close(false);
    if (target >= 0) all[target]?.focus();
    if (target >= 0 || e.key === "Escape") {
      e.preventDefault();
      e.stopPropagation();
    }
  };

  return (
    <div role="menu" aria-label={label} class={`menu-list ${at ? "free" : ""}`} ref={root} onKeyDown={onKeyDown}>
      {items.map((item, i) => (
        <>
          {item.group !== undefined && item.group !== items[i - 1]?.group && <div class="menu-group" role="presentation">{item.group}</div>}
          <button
            type="button"
            role="menuitem"
            tabIndex={-1}
            aria-label={item.name}
            aria-disabled={item.disabled || undefined}
            data-tip={item.tip}
            onClick={() => {
              if (item.disabled) return;
              close(true);
              item.run();
            }}
          >
            <span>{item.label}</span>
            {item.keys && <kbd aria-hidden="true">{item.keys}</kbd>}
          </button>
        </>
      ))}
    </div>
  );
}

/** A button that opens a list of commands. */
export function Menu({ label, items, icon, tip, showLabel = true }: MenuProps) {
  const [isOpen, setOpen] = useState(false);
  const button = useRef<HTMLButtonElement>(null);
  const close = (returnsFocus: boolean) => {
    setOpen(false);
    if (returnsFocus) button.current?.focus();
  };
  return (
    <div class="menu">
      <button
        ref={button}
        type="button"
        class={`button quiet ${showLabel ? "" : "only-icon"}`}
        aria-label={label}
        aria-haspopup="menu"
        aria-expanded={isOpen}
        data-tip={isOpen ? undefined : tip ?? (showLabel ? undefined : label)}
        onClick={() => setOpen(!isOpen)}
      >
        {icon && <Icon name={icon} />}
        {showLabel && <span>{label}</span>}
        {showLabel && <Icon name="down" />}
      </button>
      {isOpen && <MenuList label={label} items={items} close={close} />}
    </div>
  );
}
