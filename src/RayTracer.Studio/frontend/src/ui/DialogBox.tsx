import type { ComponentChildren } from "preact";
import { useLayoutEffect, useRef } from "preact/hooks";
import { texts } from "../texts";
import { Button } from "./Button";

interface DialogBoxProps {
  title: string;
  onClose: () => void;
  children: ComponentChildren;
  buttons?: ComponentChildren;
  wide?: boolean;
  /** As wide and high as the window allows. */
  full?: boolean;
  /** The help's page about it. */
  help?: string;
}

/** A modal dialog; Escape and the close button end it. The keyboard is in the field with `data-first`, where there is one. */
export function DialogBox({ title, onClose, children, buttons, wide, full, help }: DialogBoxProps) {
  const ref = useRef<HTMLDialogElement>(null);
  // A layout effect, so that no key goes past the dialog, and the focus is back before the next one.
  useLayoutEffect(() => {
    const box = ref.current!;
    const before = document.activeElement as HTMLElement | null;
    box.showModal();
    const first = box.querySelector<HTMLInputElement>("[data-first]");
    first?.focus();
    first?.select();
    return () => {
      box.close();
      before?.focus?.();
    };
  }, []);
  const onCancel = (e: Event) => {
    e.preventDefault();
    onClose();
  };
  // Keys pressed in a dialog are no shortcuts of the window behind it.
  const onKeyDown = (e: KeyboardEvent) => e.stopPropagation();
  return (
    <dialog ref={ref} class={full ? "full" : wide ? "wide" : ""} data-help={help} aria-label={title} onCancel={onCancel} onKeyDown={onKeyDown}>
      <header>
        <h2>{title}</h2>
        <Button label={texts.dialogs.close} icon="close" onClick={onClose} />
      </header>
      {/* Without a button at its end, keys scroll what is too long. */}
      <div class="dialog-body" tabIndex={buttons ? undefined : 0}>{children}</div>
      {buttons && <footer>{buttons}</footer>}
    </dialog>
  );
}
