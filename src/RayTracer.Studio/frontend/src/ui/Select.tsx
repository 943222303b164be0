interface SelectProps {
  label: string;
  value: string;
  choices: readonly { value: string; label: string; group?: string | undefined }[];
  /** Returns false where the choice waits for an answer: until then, the list shows what is so. */
  onChange: (value: string) => unknown;
  tip?: string | undefined;
  id?: string;
  disabled?: boolean;
}

/** The browser's own list of choices, in groups where they are given. */
export function Select({ label, value, choices, onChange, tip, id, disabled }: SelectProps) {
  const groups = [...new Set(choices.map((c) => c.group))];
  const options = (group: string | undefined) =>
    choices.filter((c) => c.group === group).map((c) => <option value={c.value} selected={c.value === value}>{c.label}</option>);
  const change = (list: HTMLSelectElement) => {
    if (onChange(list.value) === false) list.value = value;
  };
  return (
    <select id={id} aria-label={label} data-tip={tip} disabled={disabled} value={value} onChange={(e) => change(e.currentTarget)}>
      {groups.map((group) => (group === undefined ? options(group) : <optgroup label={group}>{options(group)}</optgroup>))}
    </select>
  );
}
