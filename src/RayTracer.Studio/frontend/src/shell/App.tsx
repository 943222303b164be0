import { useLayoutEffect } from "preact/hooks";
import { ExportDialog } from "../files/ExportDialog";
import { OpenDialog, SaveSceneDialog, WantedFileDialog } from "../files/FileDialogs";
import { Gallery } from "../files/Gallery";
import { OverwriteQuestion, RenameDialog, UnsavedQuestion } from "../files/Questions";
import { Recent } from "../files/Recent";
import { HelpDialog } from "../help/HelpDialog";
import { lesson } from "../help/lesson";
import { LessonPane } from "../help/LessonPane";
import { Outliner } from "../outliner/Outliner";
import { PropertyPanel } from "../panel/PropertyPanel";
import { watchAttention } from "../help/places";
import { bottomHeight, bottomOpen, leftOpen, leftTab, leftWidth, rightOpen, rightWidth } from "../state/settings";
import { listenToShortcuts } from "../state/shortcuts";
import { BackgroundDialog } from "../files/BackgroundDialog";
import { LightsDialog } from "../files/LightsDialog";
import { connection, dialog, helpAt, isFresh, opening, pictureAlone, studio, tourStep } from "../state/store";
import { texts } from "../texts";
import { Splitter } from "../ui/Splitter";
import { Tabs } from "../ui/Tabs";
import { Tooltip } from "../ui/Tooltip";
import { Viewport } from "../viewport/Viewport";
import { Banners } from "./Banners";
import { Dock } from "./Dock";
import { DropTarget } from "./DropTarget";
import { EmptyState } from "./EmptyState";
import { Messages } from "./Messages";
import { NoEntry } from "./NoEntry";
import { ShortcutSheet } from "./ShortcutSheet";
import { StatusBar } from "./StatusBar";
import { Toolbar } from "./Toolbar";
import { Tour } from "./Tour";
import { UnsentBanner } from "./UnsentBanner";

const dialogs = { open: OpenDialog, saveAs: SaveSceneDialog, export: ExportDialog, background: BackgroundDialog, lights: LightsDialog, rename: RenameDialog, shortcuts: ShortcutSheet };

function LeftPane() {
  const t = texts.left;
  return (
    <aside class="pane left" aria-label={t.label}>
      <Tabs
        label={t.label}
        chosen={leftTab}
        tabs={[
          { id: "scene", label: t.scene, help: "studio#things", render: () => <Outliner /> },
          { id: "gallery", label: t.gallery, help: "studio#start", render: () => <Gallery /> },
          { id: "files", label: t.files, help: "studio#save", render: () => <Recent /> },
          ...(lesson.value ? [{ id: "lesson", label: t.lesson, help: lesson.value, render: () => <LessonPane /> }] : []),
        ]}
      />
      <Splitter label={texts.panes.left} size={leftWidth} grows="right" minimum={180} maximum={() => innerWidth * 0.4} />
    </aside>
  );
}

function RightPane() {
  return (
    <aside class="pane right" aria-label={texts.right.label}>
      <Splitter label={texts.panes.right} size={rightWidth} grows="left" minimum={220} maximum={() => innerWidth * 0.4} />
      <PropertyPanel />
    </aside>
  );
}

function BottomPane() {
  return (
    <section class="pane bottom" aria-label={texts.dock.label}>
      <Splitter label={texts.panes.bottom} size={bottomHeight} grows="up" minimum={110} maximum={() => innerHeight * 0.7} />
      <Dock />
    </section>
  );
}

/** The whole window. */
export function App() {
  // From the first frame on: nobody waits for the second to press a key.
  useLayoutEffect(listenToShortcuts, []);
  useLayoutEffect(watchAttention, []);
  if (connection.value === "refused" && !studio.value) return <NoEntry />;
  const Shown = dialog.value && dialogs[dialog.value];
  // A fresh Studio asks what to do, and nothing else; but the tour needs something to point at.
  const isAlone = pictureAlone.value && !isFresh.value;
  const hasPanes = !isAlone && (!isFresh.value || tourStep.value !== null);
  const sizes = { "--left": `${leftWidth.value}px`, "--right": `${rightWidth.value}px`, "--bottom": `${bottomHeight.value}px` };
  return (
    <div class="window" style={sizes}>
      {!isAlone && <Toolbar />}
      <Banners />
      <UnsentBanner />
      <div class="panes">
        {hasPanes && leftOpen.value && <LeftPane />}
        <main class="centre">
          {isFresh.value && opening.value === null ? <EmptyState /> : <Viewport />}
          {hasPanes && bottomOpen.value && <BottomPane />}
        </main>
        {hasPanes && rightOpen.value && <RightPane />}
      </div>
      {!isAlone && <StatusBar />}
      <Messages />
      {Shown && <Shown />}
      <WantedFileDialog />
      <UnsavedQuestion />
      <OverwriteQuestion />
      {helpAt.value && <HelpDialog />}
      <Tour />
      <Tooltip />
      <DropTarget />
    </div>
  );
}
