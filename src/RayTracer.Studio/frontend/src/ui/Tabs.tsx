import type { Signal } from "@preact/signals";
import type { ComponentChildren } from "preact";

export interface Tab {
  id: string;
  label: string;
  render: () => ComponentChildren;
  badge?: number | undefined;
  /** The help's page about it. */
  help?: string | undefined;
}

interface TabsProps {
  label: string;
  tabs: Tab[];
  chosen: Signal<string>;
  trailing?: ComponentChildren;
}

/** Tabs by the ARIA pattern: one of them can be reached by Tab, arrows move between them. */
export function Tabs({ label, tabs, chosen, trailing }: TabsProps) {
  const current = tabs.find((t) => t.id === chosen.value) ?? tabs[0]!;
  const name = (id: string) => `tab-${label.replace(/\W+/g, "-")}-${id}`;
  const onKeyDown = (e: KeyboardEvent) => {
    const step = e.key === "ArrowRight" ? 1 : e.key === "ArrowLeft" ? -1 : 0;
    if (!step) return;
    const next = tabs[(tabs.indexOf(current) + step + tabs.length) % tabs.length]!;
    chosen.value = next.id;
    document.getElementById(name(next.id))?.focus();
    e.preventDefault();
    e.stopPropagation();
  };
  return (
    <div class="tabs">
      <div class="tab-row">
        <div role="tablist" aria-label={label} onKeyDown={onKeyDown}>
          {tabs.map((tab) => (
            <button
              type="button"
              role="tab"
              id={name(tab.id)}
              aria-selected={tab === current}
              aria-controls={`${name(tab.id)}-panel`}
              tabIndex={tab === current ? 0 : -1}
              data-help={tab.help}
              onClick={() => (chosen.value = tab.id)}
            >
              {tab.label}
              {tab.badge ? <span class="badge">{tab.badge}</span> : null}
            </button>
          ))}
        </div>
        {trailing}
      </div>
      <div class="tab-panel" role="tabpanel" data-help={current.help} tabIndex={0} id={`${name(current.id)}-panel`} aria-labelledby={name(current.id)} key={current.id}>
        {current.render()}
      </div>
    </div>
  );
}
