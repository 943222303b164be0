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

/** A button that opens a list of commands; arrow keys, Home, End and letters move in it. */
export function Menu({ label, items, icon, tip, showLabel = true }: MenuProps) {
  const [isOpen, setOpen] = useState(false);
  const root = useRef<HTMLDivElement>(null);
  const buttons = () => [...(root.current?.querySelectorAll<HTMLElement>("[role=menuitem]") ?? [])];

  const close = (focusButton: boolean) => {
    setOpen(false);
    if (focusButton) root.current?.querySelector("button")?.focus();
  };

  // A layout effect, so that the next key finds the focus in the menu, or not there any more.
  useLayoutEffect(() => {
    if (!isOpen) return;
    buttons()[0]?.focus();
    const outside = (e: PointerEvent) => root.current?.contains(e.target as Node) || close(false);
    document.addEventListener("pointerdown", outside);
    return () => document.removeEventListener("pointerdown", outside);
  }, [isOpen]);

  const onKeyDown = (e: KeyboardEvent) => {
    if (!isOpen) return;
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
    <div class="menu" ref={root} onKeyDown={onKeyDown}>
      <button
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
      {isOpen && (
        <div role="menu" aria-label={label} class="menu-list">
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
      )}
    </div>
  );
}
