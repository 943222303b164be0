import type { ComponentType } from "preact";
import { bottomTab } from "../state/settings";
import { texts } from "../texts";
import { Tabs } from "../ui/Tabs";

/** A tab of the lower pane; each declares itself as the `tab` of a file whose name ends in Tab, and has its title in the texts. */
export interface DockTab {
  id: string;
  /** Tabs stand in this order. */
  order: number;
  component: ComponentType;
  badge?: () => number | undefined;
  /** The help's page about it. */
  help: string;
}

const tabs = Object.values(import.meta.glob<DockTab>("../*/*Tab.tsx", { eager: true, import: "tab" })).sort((a, b) => a.order - b.order);
const titles: Record<string, string> = texts.dock;

/** The lower pane. */
export function Dock() {
  return (
    <Tabs
      label={texts.dock.label}
      chosen={bottomTab}
      tabs={tabs.map(({ id, component: Component, badge, help }) => ({ id, label: titles[id] ?? id, badge: badge?.(), help, render: () => <Component /> }))}
    />
  );
}
