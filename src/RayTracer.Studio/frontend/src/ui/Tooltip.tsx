/** One tooltip for the window: it shows the `data-tip` and `data-keys` of what the pointer rests on or what was reached by keyboard. */

import { signal } from "@preact/signals";
import { useEffect, useLayoutEffect, useRef } from "preact/hooks";

const shown = signal<{ text: string; keys: string; target: Element } | null>(null);
const restingTime = 450;

function listen(): () => void {
  let timer = 0;
  const hide = () => {
    clearTimeout(timer);
    shown.value = null;
  };
  const consider = (event: Event, delay: number) => {
    const target = event.target instanceof Element ? event.target.closest("[data-tip]") : null;
    if (target === shown.value?.target) return;
    hide();
    if (!target) return;
    const { tip = "", keys = "" } = (target as HTMLElement).dataset;
    timer = window.setTimeout(() => (shown.value = { text: tip, keys, target }), delay);
  };
  const over = (e: Event) => consider(e, restingTime);
  const focus = (e: Event) => e.target instanceof Element && e.target.matches(":focus-visible") && consider(e, restingTime);
  const key = (e: KeyboardEvent) => e.key === "Escape" && hide();
  document.addEventListener("pointerover", over);
  document.addEventListener("pointerdown", hide);
  document.addEventListener("focusin", focus);
  document.addEventListener("focusout", hide);
  document.addEventListener("keydown", key);
  return () => {
    document.removeEventListener("pointerover", over);
    document.removeEventListener("pointerdown", hide);
    document.removeEventListener("focusin", focus);
    document.removeEventListener("focusout", hide);
    document.removeEventListener("keydown", key);
  };
}

export function Tooltip() {
  const box = useRef<HTMLDivElement>(null);
  useEffect(listen, []);
  const tip = shown.value;
  useLayoutEffect(() => {
    if (!tip || !box.current) return;
    tip.target.setAttribute("aria-describedby", "tooltip");
    const around = tip.target.getBoundingClientRect();
    const { offsetWidth: width, offsetHeight: height } = box.current;
    const below = around.bottom + 6 + height < innerHeight;
    const left = Math.min(Math.max(6, around.left + around.width / 2 - width / 2), innerWidth - width - 6);
    box.current.style.left = `${left}px`;
    box.current.style.top = `${Math.max(6, below ? around.bottom + 6 : around.top - height - 6)}px`;
    return () => tip.target.removeAttribute("aria-describedby");
  }, [tip]);
  return tip ? (
    <div class="tooltip" role="tooltip" id="tooltip" ref={box}>
      {tip.text} {tip.keys && <kbd>{tip.keys}</kbd>}
    </div>
  ) : null;
}
