import { effect } from "@preact/signals";
import { useEffect, useRef } from "preact/hooks";
import { token } from "../api/client";
import { texts } from "../texts";
import { headerSize, readHeader } from "./frame";
import type { ToWorker } from "./frames.worker";
import { pace } from "./pace";
import { Painter } from "./painter";
import { cameraMoves, isOwnPicture, movingFrames, paintedDocument, paintedFrames, paintedPixels, picture, placement, zoom } from "./stage";

const resizePause = 150;

/** Follows the server's frames and paints them; ends with the function that it returns. */
function followFrames(canvas: HTMLCanvasElement): () => void {
  const context = canvas.getContext("2d", { alpha: false })!;
  const worker = new Worker(new URL("./frames.worker.ts", import.meta.url), { type: "module" });
  const post = (message: ToWorker) => worker.postMessage(message);

  let painted = 0;
  const painter = new Painter<ArrayBuffer>((paint) => requestAnimationFrame(paint), (bytes) => {
    const frame = readHeader(bytes);
    if (canvas.width !== frame.width || canvas.height !== frame.height) [canvas.width, canvas.height] = [frame.width, frame.height];
    paintedPixels.value = new Uint8ClampedArray(bytes, headerSize);
    context.putImageData(new ImageData(paintedPixels.peek(), frame.width, frame.height), 0, 0);
    if (picture.peek().width !== frame.pictureWidth || picture.peek().height !== frame.pictureHeight) {
      picture.value = { width: frame.pictureWidth, height: frame.pictureHeight };
    }
    paintedDocument.value = frame.document;
    if (cameraMoves.peek()) movingFrames.value++;
    paintedFrames.value++;
    if (frame.isPreview) pace.painted(performance.now());
    // For measurements of how quickly pictures follow what is done.
    Object.assign(canvas.dataset, { painted: String(++painted), version: String(frame.version), samples: String(frame.samples), preview: String(frame.isPreview) });
    post({ kind: "painted" });
  });
  worker.onmessage = (event: MessageEvent<ArrayBuffer>) => painter.push(event.data);

  const watch = () => post({ kind: "watch", isVisible: !document.hidden });
  let resizing = 0;
  const resized = effect(() => {
    const { width, height } = picture.value;
    const scale = Math.min(1, placement.value.scale * devicePixelRatio);
    clearTimeout(resizing);
    resizing = window.setTimeout(() => post({ kind: "size", width: Math.ceil(width * scale), height: Math.ceil(height * scale) }), resizePause);
  });
  document.addEventListener("visibilitychange", watch);
  watch();
  post({ kind: "start", token });
  return () => {
    document.removeEventListener("visibilitychange", watch);
    resized();
    clearTimeout(resizing);
    worker.terminate();
  };
}

/** The rendered picture itself. */
export function PictureCanvas() {
  const ref = useRef<HTMLCanvasElement>(null);
  useEffect(() => followFrames(ref.current!), []);
  const { scale, left, top } = placement.value;
  const { width, height } = picture.value;
  // Enlarged pixels are shown as they are; a coarse preview, or a picture made smaller, is smoothed.
  const isSharp = zoom.value !== null && scale * devicePixelRatio >= 1 && !cameraMoves.value;
  return (
    <canvas
      ref={ref}
      class={`picture ${isSharp ? "sharp" : ""}`}
      role="img"
      aria-label={texts.viewport.label}
      width={1}
      hidden={!isOwnPicture.value}
      height={1}
      style={{ left: `${left}px`, top: `${top}px`, width: `${width * scale}px`, height: `${height * scale}px` }}
    />
  );
}
