import { useRef, useState } from "preact/hooks";
import { clamp, dragged, format, parse, stepOf, tidy, type Bounds, type Speed } from "../json/numbers";
import { newGesture } from "../state/edits";
import { texts } from "../texts";

interface NumberFieldProps {
  label: string;
  value: number;
  bounds: Bounds;
  onChange: (value: number, gesture: string) => void;
  tip?: string | undefined;
  /** A letter in front, as of an axis. */
  mark?: string | undefined;
  id?: string | undefined;
}

const speedOf = (e: { shiftKey: boolean; altKey: boolean }): Speed => (e.shiftKey ? "coarse" : e.altKey ? "fine" : "normal");
const clickDistance = 3;

/** With as many digits as the narrow fields of vectors and colours have room for. */
const short = (value: number) => [4, 3, 2].map((digits) => format(value, digits)).find((text) => text.length <= 6) ?? format(value, 2);

/** A number that can be typed, dragged sideways, and stepped by arrow keys. */
export function NumberField({ label, value, bounds, onChange, tip, mark, id }: NumberFieldProps) {
  const [typed, setTyped] = useState<string | null>(null);
  const [held, setHeld] = useState<number | null>(null);
  const keyGesture = useRef(newGesture());
  const shown = held ?? value;

  const commit = (text: string) => {
    const number = parse(text);
    setTyped(null);
    if (number !== null && number !== value) onChange(clamp(number, bounds), newGesture());
  };

  const onPointerDown = (e: PointerEvent) => {
    const box = e.currentTarget as HTMLInputElement;
    if (document.activeElement === box || e.button !== 0) return;
    e.preventDefault();
    const gesture = newGesture();
    let moved = false;
    let next = value;
    box.setPointerCapture(e.pointerId);
    box.onpointermove = (move) => {
      const distance = move.clientX - e.clientX;
      moved ||= Math.abs(distance) > clickDistance;
      if (!moved) return;
      const wanted = dragged(value, distance, bounds, speedOf(move));
      if (wanted === next) return;
      next = wanted;
      setHeld(next);
      onChange(next, gesture);
    };
    box.onlostpointercapture = () => {
      box.onpointermove = box.onlostpointercapture = null;
      setHeld(null);
      if (!moved) {
        box.focus();
        box.select();
      }
    };
  };

  const onKeyDown = (e: KeyboardEvent) => {
    const box = e.currentTarget as HTMLInputElement;
    if (e.key === "Enter") commit(box.value);
    else if (e.key === "Escape" && typed !== null) setTyped(null);
    else if (e.key === "ArrowUp" || e.key === "ArrowDown") {
      const step = stepOf(value, bounds, speedOf(e));
      const from = (typed !== null ? parse(typed) : null) ?? value;
      setTyped(null);
      onChange(tidy(clamp(from + (e.key === "ArrowUp" ? step : -step), bounds), step), keyGesture.current);
      e.preventDefault();
    } else return;
    e.stopPropagation();
  };

  return (
    <span class={`number ${mark ? "marked" : ""}`}>
      {mark && <span class="mark" aria-hidden="true">{mark}</span>}
      <input
        id={id}
        type="text"
        inputMode="decimal"
        role="spinbutton"
        aria-label={label}
        aria-valuenow={shown}
        aria-valuemin={bounds.minimum ?? undefined}
        aria-valuemax={bounds.maximum ?? undefined}
        data-tip={[tip, texts.panel.drag].filter(Boolean).join(" ")}
        value={typed ?? (mark ? short(shown) : format(shown))}
        onInput={(e) => setTyped(e.currentTarget.value)}
        onFocus={() => (keyGesture.current = newGesture())}
        onBlur={(e) => typed !== null && commit(e.currentTarget.value)}
        onKeyDown={onKeyDown}
        onPointerDown={onPointerDown}
      />
    </span>
  );
}
