import type { ComponentChildren } from "preact";
import { Icon, type IconName } from "./Icon";

export interface ButtonProps {
  /** The accessible name; shown beside the icon if `showLabel`. */
  label: string;
  onClick: () => void;
  icon?: IconName;
  /** Why one would press it. */
  tip?: string | undefined;
  /** Keys that do the same, for the tooltip. */
  keys?: string | undefined;
  showLabel?: boolean;
  pressed?: boolean | undefined;
  disabled?: boolean;
  kind?: "plain" | "primary" | "quiet";
  children?: ComponentChildren;
}

export function Button({ label, onClick, icon, tip, keys, showLabel, pressed, disabled, kind = "quiet", children }: ButtonProps) {
  const isText = showLabel || !icon;
  return (
    <button
      type="button"
      class={`button ${kind} ${isText ? "" : "only-icon"}`}
      aria-label={label}
      aria-pressed={pressed}
      aria-disabled={disabled || undefined}
      data-tip={isText && !tip ? undefined : [isText ? "" : label, tip].filter(Boolean).join(": ")}
      data-keys={keys}
      onClick={() => disabled || onClick()}
    >
      {icon && <Icon name={icon} />}
      {isText && <span>{label}</span>}
      {children}
    </button>
  );
}
