import { useEffect, useState } from "preact/hooks";
import { pictureAddress } from "../files/commands";
import { gradient } from "../inside/MapsTab";
import { complain } from "../state/messages";
import { compared, inspectedPixel, map, maps, renderState, tool, wipe } from "../state/store";
import { texts } from "../texts";
import { regionBetween } from "./clicks";
import { drawnRegion } from "./pointers";
import { picture, placement } from "./stage";

function Rectangle({ region, kind }: { region: number[]; kind: string }) {
  const { scale, left, top } = placement.value;
  const [x = 0, y = 0, width = 0, height = 0] = region;
  return <div class={`region ${kind}`} style={{ left: `${left + x * scale}px`, top: `${top + y * scale}px`, width: `${width * scale}px`, height: `${height * scale}px` }} />;
}

/** The render region, or the one that is being drawn. */
export function RegionOverlay() {
  const drawn = drawnRegion.value;
  const region = renderState.value?.region;
  if (drawn) {
    const rectangle = regionBetween(drawn.a, drawn.b, picture.value);
    return rectangle && <Rectangle region={rectangle} kind="drawn" />;
  }
  return region ? <Rectangle region={region} kind="chosen" /> : null;
}

/** Where the inspected pixel is. */
export function InspectMark() {
  const pixel = inspectedPixel.value;
  if (!pixel || tool.value !== "inspect") return null;
  const { scale, left, top } = placement.value;
  const style = { left: `${left + (pixel.x + 0.5) * scale}px`, top: `${top + (pixel.y + 0.5) * scale}px` };
  return <div class="inspect-mark" style={style}><span>{texts.viewport.inspected(pixel.x, pixel.y)}</span></div>;
}

/** What the colours of a map mean. */
export function MapLegend() {
  const legend = renderState.value?.legend;
  const shown = maps.value.find((m) => m.name === map.value);
  if (!legend || !shown) return null;
  return (
    <p class="chip legend">
      <span class="scale" style={{ background: gradient(shown.scale) }} aria-hidden="true" />
      <span><strong>{shown.title}</strong>: {legend}</span>
    </p>
  );
}

/** A picture of the server's, as an address for an image; empty before it is there. */
export function usePicture(path: string, query: Record<string, string | number>): string {
  const [source, setSource] = useState("");
  const written = JSON.stringify(query);
  useEffect(() => {
    let isGone = false;
    pictureAddress(path, query).then((address) => (isGone ? URL.revokeObjectURL(address) : setSource(address)), complain);
    return () => {
      isGone = true;
    };
  }, [path, written]);
  useEffect(() => () => URL.revokeObjectURL(source), [source]);
  return source;
}

interface OverProps {
  path: string;
  query: Record<string, string | number>;
  alt: string;
  /** The share that is cut off on the right. */
  cut?: number;
}

/** A picture of the server's over the one on the stage. */
function Over({ path, query, alt, cut = 0 }: OverProps) {
  const source = usePicture(path, query);
  const { scale, left, top } = placement.value;
  const { width, height } = picture.value;
  if (!source) return null;
  return (
    <img
      class="overlay"
      src={source}
      alt={alt}
      style={{ left: `${left}px`, top: `${top}px`, width: `${width * scale}px`, height: `${height * scale}px`, clipPath: `inset(0 ${cut * 100}% 0 0)` }}
    />
  );
}

/** What is compared with the picture, over it: another one, cut off at a line that can be dragged, or the difference of two. */
export function Comparison() {
  const { left, right, shown } = compared.value;
  if (left === null) return null;
  if (shown !== "wipe") return <Over path="view/compare/picture" query={{ image: left, reference: right!, map: shown }} alt={texts.compare[shown]} />;
  return (
    <>
      {right !== null && <Over path="view/snapshot" query={{ id: right }} alt={texts.viewport.keptPicture} />}
      <Over path="view/snapshot" query={{ id: left }} alt={texts.viewport.keptPicture} cut={1 - wipe.value} />
      <WipeLine />
    </>
  );
}

function WipeLine() {
  const { scale, left, top } = placement.value;
  const size = { width: picture.value.width * scale, height: picture.value.height * scale };
  const set = (value: number) => (wipe.value = Math.min(1, Math.max(0, value)));
  const onPointerDown = (e: PointerEvent) => {
    const handle = e.currentTarget as HTMLElement;
    const start = e.clientX - wipe.value * size.width;
    handle.setPointerCapture(e.pointerId);
    handle.onpointermove = (move) => set((move.clientX - start) / size.width);
    handle.onlostpointercapture = () => (handle.onpointermove = null);
    e.preventDefault();
  };
  const onKeyDown = (e: KeyboardEvent) => {
    const step = { ArrowLeft: -0.02, ArrowRight: 0.02 }[e.key];
    if (!step) return;
    set(wipe.value + step);
    e.preventDefault();
    e.stopPropagation();
  };
  return (
    <div
      class="wipe"
      role="slider"
      tabIndex={0}
      aria-label={texts.viewport.wipe}
      aria-valuemin={0}
      aria-valuemax={100}
      aria-valuenow={Math.round(wipe.value * 100)}
      data-handle="wipe"
      style={{ left: `${left + wipe.value * size.width}px`, top: `${top}px`, height: `${size.height}px` }}
      onPointerDown={onPointerDown}
      onKeyDown={onKeyDown}
    />
  );
}
