import { useState } from "preact/hooks";

interface TextFieldProps {
  label: string;
  value: string;
  onCommit: (value: string) => void;
  tip?: string | undefined;
  id?: string | undefined;
  placeholder?: string | undefined;
  list?: string | undefined;
}

/** A text that counts when it is left or Enter is pressed; Escape brings the old one back. */
export function TextField({ label, value, onCommit, tip, id, placeholder, list }: TextFieldProps) {
  const [typed, setTyped] = useState<string | null>(null);
  const commit = () => {
    if (typed !== null && typed !== value) onCommit(typed);
    setTyped(null);
  };
  const onKeyDown = (e: KeyboardEvent) => {
    if (e.key === "Enter") commit();
    else if (e.key === "Escape" && typed !== null) {
      setTyped(null);
      e.stopPropagation();
    }
  };
  return (
    <input
      id={id}
      type="text"
      class="text"
      aria-label={label}
      data-tip={tip}
      placeholder={placeholder}
      list={list}
      spellcheck={false}
      value={typed ?? value}
      onInput={(e) => setTyped(e.currentTarget.value)}
      onBlur={commit}
      onKeyDown={onKeyDown}
    />
  );
}
