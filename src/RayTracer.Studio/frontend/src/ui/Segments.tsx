interface SegmentsProps {
  label: string;
  value: string;
  choices: readonly { value: string; label: string; tip?: string }[];
  onChange: (value: string) => void;
}

/** A few choices side by side, of which one holds. */
export function Segments({ label, value, choices, onChange }: SegmentsProps) {
  const onKeyDown = (e: KeyboardEvent) => {
    const step = e.key === "ArrowRight" ? 1 : e.key === "ArrowLeft" ? -1 : 0;
    if (!step) return;
    const here = choices.findIndex((c) => c.value === value);
    const next = (here + step + choices.length) % choices.length;
    onChange(choices[next]!.value);
    (e.currentTarget as HTMLElement).querySelectorAll<HTMLElement>("[role=radio]")[next]?.focus();
    e.preventDefault();
    e.stopPropagation();
  };
  return (
    <div class="segments" role="radiogroup" aria-label={label} onKeyDown={onKeyDown}>
      {choices.map((c) => (
        <button type="button" role="radio" aria-checked={c.value === value} tabIndex={c.value === value ? 0 : -1} data-tip={c.tip} onClick={() => onChange(c.value)}>
          {c.label}
        </button>
      ))}
    </div>
  );
}
