import { signal } from "@preact/signals";
import { useEffect } from "preact/hooks";
import type { InspectedPath, InspectedPixel, InspectedVertex, InspectedWay } from "../api/types";
import { toHex } from "../json/color";
import { format } from "../json/numbers";
import { select } from "../state/edits";
import { inspectedPixel } from "../state/store";
import { texts } from "../texts";
import { Button } from "../ui/Button";
import { NumberField } from "../ui/NumberField";
import { picture } from "../viewport/stage";
import { rgb } from "./format";
import { chosenSample, chosenWay, drawsAll, firstSample, followPaths, litSamples, openVertex, paths, pointedSample, pointedVertex } from "./paths";
import { PathScene } from "./PathScene";
import { PixelBars } from "./PixelBars";
import { TreeStepper } from "./TreeStepper";
import { VertexEquation, WayEquation } from "./VertexEquation";
import type { DockTab } from "../shell/Dock";

const t = texts.paths;

function PixelChooser() {
  const pixel = inspectedPixel.value ?? { x: Math.floor(picture.value.width / 2), y: Math.floor(picture.value.height / 2) };
  const bounds = (size: number) => ({ minimum: 0, maximum: Math.max(0, size - 1), isInteger: true });
  return (
    <div class="pixel-chooser">
      <NumberField label={t.x} mark="x" value={pixel.x} bounds={bounds(picture.value.width)} onChange={(x) => (inspectedPixel.value = { ...pixel, x })} />
      <NumberField label={t.y} mark="y" value={pixel.y} bounds={bounds(picture.value.height)} onChange={(y) => (inspectedPixel.value = { ...pixel, y })} />
      {!inspectedPixel.value && <Button label={t.show} showLabel kind="plain" onClick={() => (inspectedPixel.value = pixel)} />}
    </div>
  );
}

const luminance = ([r = 0, g = 0, b = 0]: readonly number[]) => 0.2126 * r + 0.7152 * g + 0.0722 * b;

const pointing = (sample: number) => {
  const [on, off] = [() => (pointedSample.value = sample), () => (pointedSample.value = -1)];
  return { onPointerEnter: on, onPointerLeave: off, onFocus: on, onBlur: off };
};

function SampleList({ answer }: { answer: InspectedPixel }) {
  return (
    <div class="sample-list">
      <PixelChooser />
      {answer.pixel && <p class="mean"><span class="swatch" style={{ background: toHex(answer.pixel) }} /> {t.mean}<br /><span class="figures">{rgb(answer.pixel)}</span></p>}
      <div class="pair">
        <Button label={t.fewer} icon="previous" disabled={firstSample.value === 0} onClick={() => (firstSample.value = Math.max(0, firstSample.value - answer.samples.length))} />
        <span>{t.list}</span>
        <Button label={t.more} icon="chevron" disabled={firstSample.value + answer.samples.length >= answer.total} onClick={() => (firstSample.value += answer.samples.length)} />
      </div>
      <ul aria-label={t.list}>
        {answer.samples.map((s) => (
          <li key={s.sample}>
            <button type="button" class={`list-button ${litSamples.value && !litSamples.value.includes(s.sample) ? "dimmed" : ""} ${pointedSample.value === s.sample ? "pointed" : ""}`} {...pointing(s.sample)} aria-pressed={s.sample === chosenSample.value} onClick={() => ([chosenSample.value, chosenWay.value] = [s.sample, -1])}>
              <span class="swatch" style={{ background: toHex(s.radiance) }} /><span class="hidden-text">{t.sample}</span> {s.sample}<span class="figures" data-tip={rgb(s.radiance)}>{format(luminance(s.radiance), 3)}</span>
            </button>
          </li>
        ))}
      </ul>
    </div>
  );
}

const reveal = (row: HTMLElement | null) => row?.scrollIntoView({ block: "nearest" });

function VertexRow({ vertex, index }: { vertex: InspectedVertex; index: number }) {
  const isOpen = openVertex.value === index;
  return (
    <>
      <tr class={`${isOpen ? "open" : ""} ${pointedVertex.value === index ? "pointed" : ""}`} onPointerEnter={() => (pointedVertex.value = index)} onPointerLeave={() => (pointedVertex.value = -1)}>
        <td><button type="button" class="link" aria-expanded={isOpen} aria-label={t.open(index)} onClick={() => (openVertex.value = isOpen ? -1 : index)}>{isOpen ? "▾" : "▸"} {index}</button></td>
        <td data-tip={t.eventsWhy[vertex.event]}><span class={`event ${vertex.event}`}>{t.events[vertex.event] ?? vertex.event}</span></td>
        <td class="thing">{vertex.pointer ? <button type="button" class="link" onClick={() => select(vertex.pointer)}>{vertex.name ?? vertex.pointer}</button> : vertex.name}<span class="material">{vertex.material}</span></td>
        <td class="figures">{rgb(vertex.throughput)}</td>
        <td class="figures">{rgb(vertex.contribution)}</td>
      </tr>
      {isOpen && <tr class="opened" ref={reveal}><td colSpan={5}><VertexEquation vertex={vertex} /></td></tr>}
    </>
  );
}

/** Names of things stand between asterisks. */
const emphasized = (sentence: string) => sentence.split("*").map((part, i) => (i % 2 ? <em key={i}>{part}</em> : part));

function VertexTable({ sample }: { sample: InspectedPath }) {
  return (
    <>
      <p class="sentence">{emphasized(sample.sentence)}</p>
      <table>
        <caption>{t.sample} {sample.sample}</caption>
        <thead>
          <tr><th scope="col">#</th><th scope="col">{t.event}</th><th scope="col">{t.thing}</th><th scope="col" data-tip={t.throughputWhy}>{t.throughput}</th><th scope="col" data-tip={t.contributionWhy}>{t.contribution}</th></tr>
        </thead>
        <tbody>{sample.vertices.map((v, i) => <VertexRow vertex={v} index={i} key={i} />)}</tbody>
        <tfoot><tr><th scope="row" colSpan={4}>{t.total}</th><td class="figures">{rgb(sample.radiance)}</td></tr></tfoot>
      </table>
      <p class="quiet">{t.explain}</p>
      {sample.ways.length > 0 && <WayTable ways={sample.ways} />}
    </>
  );
}

const view = signal<"sample" | "pixel" | "tree">("sample");

/** One sample, vertex by vertex, what all of them together say, or the way of a ray through a tree. */
function Explanation({ sample }: { sample: InspectedPath | undefined }) {
  return (
    <div class="vertices" role="region" aria-label={t.table} tabIndex={0}>
      <div class="group" role="group" aria-label={t.views}>
        {(["sample", "pixel", "tree"] as const).map((v) => <Button key={v} label={t.viewNames[v]} showLabel pressed={view.value === v} onClick={() => (view.value = v)} />)}
        <label><input type="checkbox" checked={drawsAll.value} onChange={(e) => (drawsAll.value = e.currentTarget.checked)} /> {t.drawAll}</label>
      </div>
      {view.value === "pixel" ? <PixelBars /> : view.value === "tree" ? <TreeStepper /> : sample && <VertexTable sample={sample} />}
    </div>
  );
}

function WayRow({ way, index }: { way: InspectedWay; index: number }) {
  const isOpen = chosenWay.value === index;
  return (
    <>
      <tr class={isOpen ? "open" : ""}>
        <td><button type="button" class="link" aria-expanded={isOpen} aria-label={t.openWay(way.lightVertices, way.cameraVertices)} onClick={() => (chosenWay.value = isOpen ? -1 : index)}>{isOpen ? "▾" : "▸"} {way.lightVertices} + {way.cameraVertices}</button></td>
        <td data-tip={t.eventsWhy[way.event]}><span class={`event ${way.event}`}>{t.events[way.event] ?? way.event}</span></td>
        <td>{[way.light, ...way.things].filter(Boolean).join(" → ")}</td>
        <td class="figures">{format(way.weight, 3)}</td>
        <td class="figures">{rgb(way.radiance)}</td>
      </tr>
      {isOpen && <tr class="opened" ref={reveal}><td colSpan={5}><WayEquation way={way} /></td></tr>}
    </>
  );
}

function WayTable({ ways }: { ways: InspectedWay[] }) {
  return (
    <>
      <table>
        <caption>{t.ways}</caption>
        <thead>
          <tr><th scope="col">{t.wayVertices}</th><th scope="col">{t.event}</th><th scope="col">{t.wayThings}</th><th scope="col">{t.wayWeight}</th><th scope="col">{t.contribution}</th></tr>
        </thead>
        <tbody>{ways.map((w, i) => <WayRow way={w} index={i} key={i} />)}</tbody>
      </table>
      <p class="quiet">{t.explainWays}</p>
    </>
  );
}

/** The light paths of one pixel: which samples there are, the vertices of one as a table, and all of them in the scene. */
function PathsTab() {
  useEffect(() => followPaths(), []);
  const answer = paths.value;
  if (!inspectedPixel.value || !answer) {
    return (
      <div class="pad">
        <p>{t.none} {t.how}</p>
        <PixelChooser />
      </div>
    );
  }
  const sample = answer.samples.find((s) => s.sample === chosenSample.value) ?? answer.samples[0];
  return (
    <div class="paths" role="group" aria-label={`${t.label}: ${t.pixel(answer.x, answer.y)}`}>
      <SampleList answer={answer} />
      <Explanation sample={sample} />
      <PathScene samples={answer.samples} chosen={sample?.sample ?? -1} way={chosenWay.value} />
    </div>
  );
}

export const tab: DockTab = { id: "paths", order: 2, help: "studio#look-inside", component: PathsTab };
