import { useEffect, useRef } from "preact/hooks";
import { PathOverlay } from "../inside/PathOverlay";
import { documentState, pictureAlone, renderState, tool } from "../state/store";
import { draggedThing, droppedThing } from "../outliner/drag";
import { applyTo } from "../state/edits";
import { commandButton } from "../state/commands";
import { texts } from "../texts";
import { Button } from "../ui/Button";
import { Gizmo } from "./Gizmo";
import { onCameraKey, onCameraKeyUp, releaseKeys } from "./keys";
import { LightBodies } from "./LightBodies";
import { OwnView } from "./OwnView";
import { HereMenu, openHere } from "./HereMenu";
import { Comparison, InspectMark, MapLegend, RegionOverlay } from "./Overlays";
import { PictureCanvas } from "./PictureCanvas";
import { PixelValues } from "./PixelValues";
import { listenToPointers, spaceHeld } from "./pointers";
import { MotionPaths } from "../timeline/MotionPaths";
import { SelectionOutline } from "./SelectionOutline";
import { cameraMoves, isOwnPicture, pixelAt, stage } from "./stage";
import { OpeningNote } from "./OpeningNote";
import { ViewportBar } from "./ViewportBar";

function openInMiddle(stage: HTMLElement): void {
  const box = stage.getBoundingClientRect();
  const middle = { x: box.width / 2, y: box.height / 2 };
  const pixel = pixelAt(middle);
  if (pixel) openHere({ x: box.left + middle.x, y: box.top + middle.y }, pixel);
}

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
    else if (e.key === "ContextMenu" || (e.key === "F10" && e.shiftKey)) openInMiddle(ref.current!);
    else if (!onCameraKey(e)) return;
    e.preventDefault();
    e.stopPropagation();
  };
  const onKeyUp = (e: KeyboardEvent) => {
    if (e.key === " ") spaceHeld.value = false;
    onCameraKeyUp(e);
  };

  const onDragOver = (e: DragEvent) => {
    if (!draggedThing(e)) return;
    e.preventDefault();
    e.dataTransfer!.dropEffect = "link";
  };
  const onDrop = (e: DragEvent) => {
    const pointer = droppedThing(e);
    const box = ref.current!.getBoundingClientRect();
    const pixel = pixelAt({ x: e.clientX - box.left, y: e.clientY - box.top });
    if (!pointer) return;
    e.preventDefault();
    if (pixel) applyTo(pointer, { at: [pixel.x, pixel.y] });
  };

  const isOld = documentState.value !== null && !documentState.value.isGood && documentState.value.diagnostics.length > 0;
  return (
    <section class="viewport" aria-label={texts.viewport.label} data-help="studio#the-picture">
      {!pictureAlone.value && <ViewportBar />}
      <div ref={ref} class={`stage tool-${tool.value}`} role="application" aria-label={texts.viewport.canvas} tabIndex={0} onKeyDown={onKeyDown} onKeyUp={onKeyUp} onDragOver={onDragOver} onDrop={onDrop} onBlur={releaseKeys}>
        <PictureCanvas />
        {isOwnPicture.value && (
          <>
            <SelectionOutline />
            <MotionPaths />
            <MapLegend />
            <Comparison />
            <PixelValues />
            <RegionOverlay />
            <PathOverlay />
            <InspectMark />
            <LightBodies />
            <Gizmo />
          </>
        )}
        <OwnView />
        {pictureAlone.value && (
          <div class="chip corner alone" data-handle="alone">
            <Button {...commandButton("alone")} />
          </div>
        )}
        <OpeningNote />
        <HereMenu />
        {isOld && isOwnPicture.value && <p class="chip warn">{texts.viewport.lastGood}</p>}
        {cameraMoves.value && renderState.value?.isPreview && <p class="chip corner">{texts.viewport.preview}</p>}
      </div>
    </section>
  );
}
