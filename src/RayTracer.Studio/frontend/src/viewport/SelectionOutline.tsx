import { useEffect, useRef } from "preact/hooks";
import { get } from "../api/client";
import type { PixelMask } from "../api/types";
import { isSeen } from "../state/edits";
import { documentState, selected, shownFrame, viewState } from "../state/store";
import { outlineOf } from "./mask";
import { cameraMoves, movingFrames, picture, placement } from "./stage";

const color = [255, 158, 44];

function draw(canvas: HTMLCanvasElement, mask: PixelMask, reach: number): void {
  [canvas.width, canvas.height] = [mask.width, mask.height];
  const image = new ImageData(mask.width, mask.height);
  outlineOf(mask, reach).forEach((isOn, i) => {
    if (isOn) image.data.set([...color, 255], 4 * i);
  });
  canvas.getContext("2d")!.putImageData(image, 0, 0);
}

// While the camera moves, every so many pixels: it must keep up with the picture.
const movingStep = 3;

/** The selected things' outlines in the picture. */
export const SelectionOutline = () => <>{(selected.value ?? []).filter(isSeen).map((pointer) => <ThingOutline pointer={pointer} key={pointer} />)}</>;

/** A thing's outline; it goes with the thing while the camera moves. */
function ThingOutline({ pointer }: { pointer: string }) {
  const ref = useRef<HTMLCanvasElement>(null);
  const step = cameraMoves.value ? movingStep : 1;
  const asking = useRef<AbortController | null>(null);
  const { scale, left, top } = placement.value;
  const { width, height } = picture.value;
  const reach = Math.max(1, Math.min(6, Math.round(1.5 / scale / step)));
  useEffect(() => {
    const canvas = ref.current;
    // One at a time while the camera moves: none would ever arrive if each frame ended the last.
    if (!canvas || (step > 1 && asking.current)) return;
    asking.current?.abort();
    const abort = (asking.current = new AbortController());
    get<PixelMask>("view/mask", { pointer, step: String(step) }, abort.signal)
      .then(
        (mask) => abort.signal.aborted || draw(canvas, mask, reach),
        // Not everything that can be selected is seen.
        () => abort.signal.aborted || ([canvas.width, canvas.height] = [1, 1]),
      )
      .finally(() => asking.current === abort && (asking.current = null));
    return () => {
      if (step === 1) abort.abort();
    };
  }, [pointer, documentState.value?.builtRevision, viewState.value?.picture, shownFrame.value, width, height, reach, step, step > 1 ? movingFrames.value : 0]);
  return (
    <canvas
      ref={ref}
      class="overlay"
      aria-hidden="true"
      width={1}
      height={1}
      style={{ left: `${left}px`, top: `${top}px`, width: `${width * scale}px`, height: `${height * scale}px` }}
    />
  );
}
