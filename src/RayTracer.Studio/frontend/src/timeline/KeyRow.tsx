import { useRef, useState } from "preact/hooks";
import type { TimelineRow } from "../api/types";
import { format } from "../json/numbers";
import { newGesture, select } from "../state/edits";
import { selection } from "../state/store";
import { texts } from "../texts";
import { chosen, moveKeys, nameOfKey, removeKeys } from "./keys";
import { dragBy } from "./drag";

const t = texts.timeline;

interface KeyRowProps {
  row: TimelineRow;
  length: number;
}

/** What a row's name begins with, and the last step of it. */
export function partsOfLabel(label: string): [string, string] {
  const at = label.lastIndexOf(".");
  return at < 0 ? ["", label] : [label.slice(0, at), label.slice(at)];
}

/** The keys of one value, which can be chosen and moved. */
export function KeyRow({ row, length }: KeyRowProps) {
  const gesture = useRef("");
  const [isHeld, setHeld] = useState(false);
  const choose = (name: string, adds: boolean) => {
    const others = adds ? [...chosen.value] : [];
    chosen.value = new Set(adds && chosen.value.has(name) ? others.filter((n) => n !== name) : [...others, name]);
  };
  const onPointerDown = (e: PointerEvent, name: string) => {
    if (e.button !== 0) return;
    const key = e.currentTarget as HTMLElement;
    const perFrame = key.parentElement!.clientWidth / length;
    // One of several that are chosen may be about to be dragged with them: only a click that moves nothing chooses it alone.
    const wasChosen = chosen.value.has(name);
    if (!wasChosen) choose(name, e.shiftKey);
    key.setPointerCapture(e.pointerId);
    setHeld(true);
    key.onpointermove = (move) => (dragBy.value = Math.round((move.clientX - e.clientX) / perFrame));
    key.onlostpointercapture = () => {
      key.onpointermove = key.onlostpointercapture = null;
      setHeld(false);
      if (dragBy.value !== 0) moveKeys(dragBy.value, e.altKey);
      else if (wasChosen) choose(name, e.shiftKey);
      dragBy.value = 0;
    };
  };
  const onKeyDown = (e: KeyboardEvent, name: string) => {
    const by = { ArrowLeft: -1, ArrowRight: 1 }[e.key];
    if (e.key === "Delete") removeKeys();
    else if (e.key === " " || e.key === "Enter") choose(name, e.shiftKey);
    else if (by) {
      if (!chosen.value.has(name)) choose(name, false);
      moveKeys(by, e.altKey, gesture.current);
    } else return;
    e.preventDefault();
    e.stopPropagation();
  };
  const isSelected = selection.value === row.thing;
  const [of, what] = partsOfLabel(row.label);
  return (
    <div class={`key-row ${isSelected ? "selected" : ""}`}>
      <button type="button" class="row-name" aria-label={t.select(row.label)} data-tip={row.label} onClick={() => select(row.thing)}>
        <span class="of">{of}</span><span class="what">{what}</span>
      </button>
      <div class="key-lane" role="group" aria-label={t.keysOf(row.label)}>
        {row.items.map((key, i) => {
          const name = nameOfKey(row.keys, key.frame);
          const isChosen = chosen.value.has(name);
          const at = Math.max(0, key.frame + (isChosen ? dragBy.value : 0));
          return (
            <button
              type="button"
              class={`key ${isChosen ? "chosen" : ""} ${key.ease} ${isHeld ? "held" : ""}`}
              aria-label={t.keyAt(row.label, format(key.frame, 5))}
              aria-pressed={isChosen}
              data-tip={t.how}
              style={{ left: `${(100 * at) / length}%` }}
              key={i}
              onFocus={() => (gesture.current = newGesture())}
              onPointerDown={(e) => onPointerDown(e, name)}
              onKeyDown={(e) => onKeyDown(e, name)}
            />
          );
        })}
      </div>
    </div>
  );
}
