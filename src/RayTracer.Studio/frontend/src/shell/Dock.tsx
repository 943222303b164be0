import { ConvergenceTab } from "../inside/ConvergenceTab";
import { HeatMaps } from "../inside/HeatMaps";
import { PathsTab } from "../inside/PathsTab";
import { TimesTab } from "../inside/TimesTab";
import { SourceTab } from "../editor/SourceTab";
import { bottomTab } from "../state/settings";
import { documentState } from "../state/store";
import { texts } from "../texts";
import { Tabs } from "../ui/Tabs";

/** The lower pane. */
export function Dock() {
  const t = texts.dock;
  return (
    <Tabs
      label={t.label}
      chosen={bottomTab}
      tabs={[
        { id: "source", label: t.source, badge: documentState.value?.diagnostics.length, render: () => <SourceTab /> },
        { id: "paths", label: t.paths, render: () => <PathsTab /> },
        { id: "maps", label: t.maps, render: () => <HeatMaps /> },
        { id: "convergence", label: t.convergence, render: () => <ConvergenceTab /> },
        { id: "times", label: t.times, render: () => <TimesTab /> },
      ]}
    />
  );
}
