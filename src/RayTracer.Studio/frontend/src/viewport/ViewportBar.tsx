import { post } from "../api/client";
import { Latest } from "../api/latest";
import { format } from "../json/numbers";
import { commandButton, type CommandId } from "../state/commands";
import { attempt, complain } from "../state/messages";
import { maps, renderState, tool, toneState, type Tool } from "../state/store";
import { texts } from "../texts";
import { Button } from "../ui/Button";
import { Popover } from "../ui/Popover";
import { NumberField } from "../ui/NumberField";
import { Select } from "../ui/Select";
import { HistogramPlot } from "./HistogramPlot";
import { CameraMenu } from "./OwnView";
import { clearRegion } from "./clicks";
import { placement, zoomTo } from "./stage";

const t = texts.viewport;
const tools: [CommandId, Tool][] = [
  ["toolSelect", "select"], ["toolMove", "move"], ["toolRotate", "rotate"], ["toolScale", "scale"],
  ["toolFocus", "focus"], ["toolInspect", "inspect"], ["toolRegion", "region"],
];

const tone = new Latest<object>((change) => post("view/tone", change), complain, (older, newer) => ({ ...older, ...newer }));

/** The row above the picture. */
export function ViewportBar() {
  const now = toneState.value;
  const map = renderState.value?.map ?? "light";
  const choices = maps.value.map(({ name, title }) => ({ value: name, label: title }));
  return (
    <div class="bar" role="toolbar" aria-label={t.toolbar}>
      <div class="group" role="group" aria-label={t.tools}>
        {tools.map(([id, name]) => <Button {...commandButton(id)} pressed={tool.value === name} key={id} />)}
      </div>
      <div class="group" role="group" aria-label={t.zoom}>
        <ZoomSelect />
        <Button {...commandButton("fit")} />
        <Button {...commandButton("actualSize")} />
      </div>
      <CameraMenu />
      <Select label={t.map} tip={t.mapWhy} value={map} choices={choices} onChange={showMap} />
      {now && (
        <Popover label={t.display} icon="sliders" tip={t.displayWhy}>
          <HistogramPlot />
          <div class="pair" data-tip={t.exposureWhy}>
            <span aria-hidden="true">{t.exposure}</span>
            <input type="range" aria-label={`${t.exposure}, ${format(now.exposure)}`} min={-6} max={6} step={0.1} value={now.exposure} onInput={(e) => tone.push({ exposure: Number(e.currentTarget.value) })} />
            <NumberField label={t.exposure} value={now.exposure} bounds={{ minimum: -20, maximum: 20 }} onChange={(exposure) => tone.push({ exposure })} />
          </div>
          <label class="pair">
            <span>{t.exposureRule}</span>
            <Select label={t.exposureRule} tip={t.exposureRuleWhy} value={now.rule} choices={now.rules.map((r) => ({ value: r, label: t.exposureRules[r] }))} onChange={(rule) => tone.push({ rule })} />
          </label>
          <label class="pair">
            <span>{t.toneMap}</span>
            <Select label={t.toneMap} tip={t.toneMapWhy} value={now.toneMap} choices={now.choices.map((c) => ({ value: c, label: c }))} onChange={(toneMap) => tone.push({ toneMap })} />
          </label>
        </Popover>
      )}
      <Button {...commandButton("snapshot")} />
      {renderState.value?.region && <Button label={t.clearRegion} icon="close" onClick={clearRegion} />}
    </div>
  );
}

const percents = [12.5, 25, 50, 100, 200, 400, 800, 1600, 6400];

function ZoomSelect() {
  const now = String(Math.round(placement.value.scale * devicePixelRatio * 100));
  const known = percents.map(String);
  const choices = [...(known.includes(now) ? [] : [now]), ...known].map((value) => ({ value, label: `${value} %` }));
  return <Select label={t.zoom} tip={t.zoomWhy} value={now} choices={choices} onChange={(percent) => zoomTo(Number(percent) / 100 / devicePixelRatio)} />;
}

export const showMap = (map: string) => attempt(() => post("view/render", { map }));
