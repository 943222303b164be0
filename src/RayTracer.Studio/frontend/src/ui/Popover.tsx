import type { ComponentChildren } from "preact";
import { useEffect, useRef, useState } from "preact/hooks";
import { Icon, type IconName } from "./Icon";

interface PopoverProps {
  label: string;
  icon: IconName;
  tip: string;
  children: ComponentChildren;
}

/** A button that shows controls below it, until something else is clicked or Escape is pressed. */
export function Popover({ label, icon, tip, children }: PopoverProps) {
  const [isOpen, setOpen] = useState(false);
  const root = useRef<HTMLDivElement>(null);
  useEffect(() => {
    if (!isOpen) return;
    const outside = (e: PointerEvent) => root.current?.contains(e.target as Node) || setOpen(false);
    document.addEventListener("pointerdown", outside);
    return () => document.removeEventListener("pointerdown", outside);
  }, [isOpen]);
  const onKeyDown = (e: KeyboardEvent) => {
    if (e.key !== "Escape" || !isOpen) return;
    e.stopPropagation();
    setOpen(false);
    root.current?.querySelector("button")?.focus();
  };
  return (
    <div class="popover" ref={root} onKeyDown={onKeyDown}>
      <button type="button" class="button quiet" aria-expanded={isOpen} data-tip={isOpen ? undefined : tip} onClick={() => setOpen(!isOpen)}>
        <Icon name={icon} />
        <span>{label}</span>
        <Icon name="down" />
      </button>
      {isOpen && <div class="popover-body" role="group" aria-label={label}>{children}</div>}
    </div>
  );
}
