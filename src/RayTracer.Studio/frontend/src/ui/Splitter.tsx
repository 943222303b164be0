import type { Signal } from "@preact/signals";

interface SplitterProps {
  label: string;
  size: Signal<number>;
  /** Which way the pane beside it grows. */
  grows: "right" | "left" | "up";
  minimum: number;
  maximum: () => number;
}

/** A line between panes that can be dragged, or moved by arrow keys. */
export function Splitter({ label, size, grows, minimum, maximum }: SplitterProps) {
  const set = (value: number) => (size.value = Math.round(Math.min(Math.max(value, minimum), Math.max(minimum, maximum()))));
  const along = (e: PointerEvent) => (grows === "up" ? -e.clientY : grows === "left" ? -e.clientX : e.clientX);

  const onPointerDown = (e: PointerEvent) => {
    const line = e.currentTarget as HTMLElement;
    const start = along(e);
    const before = size.value;
    line.setPointerCapture(e.pointerId);
    line.onpointermove = (move) => set(before + along(move) - start);
    line.onlostpointercapture = () => (line.onpointermove = null);
    e.preventDefault();
  };

  const onKeyDown = (e: KeyboardEvent) => {
    const directions: Record<string, number> =
      grows === "up" ? { ArrowUp: 1, ArrowDown: -1 } : grows === "left" ? { ArrowLeft: 1, ArrowRight: -1 } : { ArrowRight: 1, ArrowLeft: -1 };
    const direction = directions[e.key];
    if (!direction) return;
    set(size.value + direction * 16);
    e.preventDefault();
  };

  return (
    <div
      class={`splitter ${grows === "up" ? "across" : "along"}`}
      role="separator"
      tabIndex={0}
      aria-label={label}
      aria-orientation={grows === "up" ? "horizontal" : "vertical"}
      aria-valuenow={size.value}
      aria-valuemin={minimum}
      aria-valuemax={Math.max(size.value, 2000)}
      onPointerDown={onPointerDown}
      onKeyDown={onKeyDown}
    />
  );
}
