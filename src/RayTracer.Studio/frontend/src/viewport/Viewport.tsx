import { useEffect, useRef } from "preact/hooks";
import { PathOverlay } from "../inside/PathOverlay";
import { documentState, renderState, tool } from "../state/store";
import { texts } from "../texts";
import { Gizmo } from "./Gizmo";
import { onCameraKey, onCameraKeyUp, releaseKeys } from "./keys";
import { LightBodies } from "./LightBodies";
import { OwnView } from "./OwnView";
import { InspectMark, RegionOverlay, Wipe } from "./Overlays";
import { PictureCanvas } from "./PictureCanvas";
import { listenToPointers, spaceHeld } from "./pointers";
import { MotionPaths } from "../timeline/MotionPaths";
import { SelectionOutline } from "./SelectionOutline";
import { cameraMoves, stage } from "./stage";
import { ViewportBar } from "./ViewportBar";

/** The picture, what is drawn over it, and what is done with it. */
export function Viewport() {
  const ref = useRef<HTMLDivElement>(null);
  useEffect(() => {
    const element = ref.current!;
    const watcher = new ResizeObserver(() => (stage.value = { width: element.clientWidth, height: element.clientHeight }));
    watcher.observe(element);
    const stopListening = listenToPointers(element);
    return () => {
      watcher.disconnect();
      stopListening();
    };
  }, []);

  const onKeyDown = (e: KeyboardEvent) => {
    if (e.target !== ref.current) return;
    if (e.key === " ") spaceHeld.value = true;
    else if (!onCameraKey(e)) return;
    e.preventDefault();
    e.stopPropagation();
  };
  const onKeyUp = (e: KeyboardEvent) => {
    if (e.key === " ") spaceHeld.value = false;
    onCameraKeyUp(e);
  };

  const isOld = documentState.value !== null && !documentState.value.isGood && documentState.value.diagnostics.length > 0;
  return (
    <section class="viewport" aria-label={texts.viewport.label}>
      <ViewportBar />
      <div ref={ref} class={`stage tool-${tool.value}`} role="application" aria-label={texts.viewport.canvas} tabIndex={0} onKeyDown={onKeyDown} onKeyUp={onKeyUp} onBlur={releaseKeys}>
        <PictureCanvas />
        <SelectionOutline />
        <MotionPaths />
        <Wipe />
        <RegionOverlay />
        <PathOverlay />
        <InspectMark />
        <LightBodies />
        <Gizmo />
        <OwnView />
        {isOld && <p class="chip warn">{texts.viewport.lastGood}</p>}
        {cameraMoves.value && renderState.value?.isPreview && <p class="chip corner">{texts.viewport.preview}</p>}
      </div>
    </section>
  );
}
