import { useEffect } from "preact/hooks";
import { post } from "../api/client";
import type { DockTab } from "../shell/Dock";
import { commandButton } from "../state/commands";
import { attempt } from "../state/messages";
import { time } from "../state/store";
import { texts } from "../texts";
import { Button } from "../ui/Button";
import { NumberField } from "../ui/NumberField";
import { Select } from "../ui/Select";
import { showsPaths } from "./drag";
import { showFrame } from "./frames";
import { KeyRow } from "./KeyRow";
import { choice, copyToPlayhead, easeKeys, removeKeys, rows } from "./keys";
import { Ruler } from "./Ruler";

const t = texts.timeline;
const emptyLength = 48;
const record = (isOn: boolean) => attempt(() => post("timeline/record", { isOn }));

function Bar() {
  const now = time.value;
  if (!now) return null;
  const length = now.frames === 0 ? "" : now.frame === null ? t.written : t.of(now.frames, (now.frames / now.framesPerSecond).toFixed(2));
  const isAny = choice.value.length > 0;
  const chosenEases = new Set(choice.value.flatMap((c) => c.numbers.map((i) => rows.value.find((r) => r.keys === c.keys)!.items[i]!.ease)));
  const eases = Object.entries(t.eases).map(([value, label]) => ({ value, label }));
  return (
    <div class="timeline-bar">
      <Button {...commandButton("frameBefore")} />
      <Button {...commandButton("play")} icon={now.isPlaying ? "pause" : "play"} pressed={now.isPlaying} />
      <Button {...commandButton("frameAfter")} />
      <Button label={t.record} tip={t.recordWhy} icon="record" pressed={now.isRecording} onClick={() => record(!now.isRecording)} />
      <label class="line frame">
        <span>{t.frame}</span>
        <NumberField label={t.frame} value={now.frame ?? 0} bounds={{ minimum: 0, maximum: null, isInteger: true }} onChange={showFrame} />
      </label>
      <span class="quiet" data-tip={t.ofWhy(now.framesPerSecond)}>{length}</span>
      {/* There without chosen keys, too: a bar that gets another line moves the keys away from under the pointer. */}
      <Select label={t.ease} tip={t.easeWhy} value={chosenEases.size === 1 ? [...chosenEases][0]! : ""} choices={chosenEases.size === 1 ? eases : [{ value: "", label: "…" }, ...eases]} disabled={!isAny} onChange={(e) => e && easeKeys(e)} />
      <Button label={t.copy} icon="copy" disabled={!isAny} onClick={copyToPlayhead} />
      <Button label={t.remove} icon="trash" disabled={!isAny} onClick={removeKeys} />
      <Button label={t.paths} tip={t.pathsWhy} icon="move" pressed={showsPaths.value} onClick={() => (showsPaths.value = !showsPaths.value)} />
      <Button {...commandButton("animate")} showLabel kind="plain" />
    </div>
  );
}

/** The frames of the animation, and its keys. */
function Timeline() {
  const now = time.value;
  // Where the keys are not seen, none are set.
  useEffect(() => () => void (time.peek()?.isRecording && record(false)), []);
  if (!now) return null;
  const last = Math.max(now.frames, now.frame ?? 0, now.frames > 0 ? 1 : emptyLength);
  const length = last * 1.03;
  return (
    <div class="timeline">
      <Bar />
      {now.complaint && <p class="quiet pad" role="status">{now.complaint}</p>}
      <div class="lanes">
        <div class="lanes-inside">
          <div class="key-row head">
            <span class="row-name" />
            <Ruler last={last} length={length} />
          </div>
          {rows.value.map((row) => <KeyRow row={row} length={length} key={row.keys} />)}
          {rows.value.length === 0 && <p class="quiet">{t.none}</p>}
          <div class="key-row over" aria-hidden="true">
            <span class="row-name" />
            <div class="key-lane"><span class="playhead" style={{ left: `${(100 * Math.min(now.frame ?? 0, length)) / length}%` }} /></div>
          </div>
        </div>
      </div>
    </div>
  );
}

export const tab: DockTab = { id: "timeline", order: 1.5, help: "studio#time", component: Timeline };
