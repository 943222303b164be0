import { useLayoutEffect, useRef, useState } from "preact/hooks";
import { Icon, type IconName } from "./Icon";

export interface MenuItem {
  label: string;
  run?: () => void;
  /** Those of a menu of its own, which the item opens beside it. */
  items?: MenuItem[] | undefined;
  tip?: string | undefined;
  keys?: string | undefined;
  disabled?: boolean | undefined;
  /** Items of another group stand below a line; its name stands above them. */
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
  /** Goes back to the menu around it; null where there is none. */
  back?: () => void;
  /** Where it stands in the window, left of `x` where there is no room right of it and `width` is what stands there; null for below its button. */
  at?: { x: number; y: number; width?: number };
}

/** A list of commands; arrow keys, Home, End and letters move in it. */
export function MenuList({ label, items, close, back, at }: MenuListProps) {
  const root = useRef<HTMLDivElement>(null);
  const pointed = useRef<MenuItem>(undefined);
  const leaving = useRef<ReturnType<typeof setTimeout>>(undefined);
  const [inner, setInner] = useState<{ item: MenuItem; button: HTMLElement; turn: number } | null>(null);
  const buttons = () => [...(root.current?.querySelectorAll<HTMLElement>(":scope > [role=menuitem]") ?? [])];

  // A layout effect, so that the next key finds the focus in the menu, or not there any more.
  useLayoutEffect(() => {
    const list = root.current!;
    if (at) {
      const left = at.width && at.x + list.offsetWidth > innerWidth ? at.x - at.width - list.offsetWidth : at.x;
      list.style.left = `${Math.max(0, Math.min(left, innerWidth - list.offsetWidth - 4))}px`;
      list.style.top = `${Math.max(0, Math.min(at.y, innerHeight - list.offsetHeight - 4))}px`;
    }
    buttons()[0]?.focus();
    if (back) return;
    const outside = (e: PointerEvent) => list.parentElement!.contains(e.target as Node) || close(false);
    const resized = () => close(false);
    document.addEventListener("pointerdown", outside);
    addEventListener("resize", resized);
    return () => {
      document.removeEventListener("pointerdown", outside);
      removeEventListener("resize", resized);
    };
  }, []);

  // Each time it is opened, the first of its items gets the focus.
  const open = (item: MenuItem, button: HTMLElement) => setInner((now) => ({ item, button, turn: (now?.turn ?? 0) + 1 }));

  const run = (item: MenuItem, button: HTMLElement) => {
    if (item.disabled) return;
    if (item.items) return open(item, button);
    close(true);
    item.run?.();
  };

  const leave = () => {
    inner?.button.focus();
    setInner(null);
  };

  // A menu that comes up under a resting mouse is not pointed at. The way into an open menu may lead over the items below its own.
  const enter = (item: MenuItem, button: HTMLElement) => {
    if (pointed.current === item) return;
    pointed.current = item;
    clearTimeout(leaving.current);
    leaving.current = setTimeout(() => {
      button.focus();
      if (item.items) open(item, button);
      else setInner(null);
    }, inner ? 200 : 0);
  };

  const onKeyDown = (e: KeyboardEvent) => {
    const all = buttons();
    const here = all.indexOf(document.activeElement as HTMLElement);
    const letter = e.key.length === 1 ? all.findIndex((b, i) => i > here && b.textContent?.toLowerCase().startsWith(e.key.toLowerCase())) : -1;
    const targets: Record<string, number> = { ArrowDown: (here + 1) % all.length, ArrowUp: (here - 1 + all.length) % all.length, Home: 0, End: all.length - 1 };
    const target = targets[e.key] ?? letter;
    const goesBack = back && (e.key === "Escape" || e.key === "ArrowLeft");
    const opens = e.key === "ArrowRight" && items[here]?.items;
    if (goesBack) back();
    else if (e.key === "Escape") close(true);
    else if (e.key === "Tab") close(false);
    else if (opens) run(items[here]!, all[here]!);
    if (target >= 0) all[target]?.focus();
    if (target >= 0 || goesBack || opens || e.key === "Escape") e.preventDefault();
    // Keys in a menu are no commands, nor for the menu around it.
    e.stopPropagation();
  };
  const sideOf = (button: HTMLElement) => {
    const { right, top, width } = button.getBoundingClientRect();
    return { x: right, y: top - 5, width };
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
            aria-disabled={item.disabled || undefined}
            aria-haspopup={item.items && "menu"}
            aria-expanded={item.items && inner?.item === item}
            data-tip={item.tip}
            onPointerMove={(e) => e.pointerType === "mouse" && (e.movementX !== 0 || e.movementY !== 0) && enter(item, e.currentTarget)}
            onClick={(e) => run(item, e.currentTarget)}
          >
            <span>{item.label}</span>
            {item.keys && <kbd aria-hidden="true">{item.keys}</kbd>}
            {item.items && <Icon name="chevron" />}
          </button>
        </>
      ))}
      {inner && (
        <div role="presentation" onPointerEnter={() => (clearTimeout(leaving.current), (pointed.current = inner.item))}>
          <MenuList label={inner.item.label} items={inner.item.items!} close={close} back={leave} at={sideOf(inner.button)} key={inner.turn} />
        </div>
      )}
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
