import { useEffect, useLayoutEffect, useRef, useState } from "preact/hooks";
import { bottomOpen, leftOpen, narrowWindow, rightOpen, tourSeen } from "../state/settings";
import { tourStep } from "../state/store";
import { texts } from "../texts";
import { Button } from "../ui/Button";
import { besideFrame } from "./beside";

/** What each step points at, and the pane that must be open for it. */
const targets: { selector: string; open?: { value: boolean } }[] = [
  { selector: ".stage" },
  { selector: ".left", open: leftOpen },
  { selector: ".right", open: rightOpen },
  { selector: ".bottom", open: bottomOpen },
  { selector: ".toolbar" },
];

const end = () => {
  tourStep.value = null;
  tourSeen.value = true;
};

/** Five steps around the window, one box at a time. */
export function Tour() {
  const step = tourStep.value;
  const box = useRef<HTMLDivElement>(null);
  const [frame, setFrame] = useState({ left: 0, top: 0, width: 0, height: 0 });
  useLayoutEffect(() => {
    if (step === null) return;
    const { selector, open } = targets[step]!;
    if (narrowWindow.matches) for (const t of targets) if (t.open) t.open.value = t.open === open;
    if (open) open.value = true;
    const measure = () => {
      const around = document.querySelector(selector)?.getBoundingClientRect();
      if (around) setFrame({ left: around.left, top: around.top, width: around.width, height: around.height });
    };
    requestAnimationFrame(measure);
    addEventListener("resize", measure);
    return () => removeEventListener("resize", measure);
  }, [step]);
  useEffect(() => box.current?.querySelector<HTMLElement>(".primary")?.focus(), [step]);
  if (step === null) return null;

  const t = texts.tour;
  const [title, text] = t.steps[step]!;
  const isLast = step === t.steps.length - 1;
  const [width, height] = [320, 200];
  const { left, top } = besideFrame(frame, { width, height }, { width: innerWidth, height: innerHeight });
  const style = { left: `${left}px`, top: `${top}px` };
  return (
    <>
      <div class="tour-frame" aria-hidden="true" style={{ left: `${frame.left}px`, top: `${frame.top}px`, width: `${frame.width}px`, height: `${frame.height}px` }} />
      <div class="tour" role="dialog" aria-label={title} ref={box} style={style} onKeyDown={(e) => e.key === "Escape" && (e.stopPropagation(), end())}>
        <p class="quiet">{t.progress(step + 1, t.steps.length)}</p>
        <h2>{title}</h2>
        <p>{text}</p>
        <div class="tour-buttons">
          {!isLast && <Button label={t.skip} showLabel onClick={end} />}
          {step > 0 && <Button label={t.back} showLabel kind="plain" onClick={() => (tourStep.value = step - 1)} />}
          <Button label={isLast ? t.done : t.next} showLabel kind="primary" onClick={() => (isLast ? end() : (tourStep.value = step + 1))} />
        </div>
      </div>
    </>
  );
}
