import { computed, effect, signal } from "@preact/signals";
import { get, Refusal } from "../api/client";
import { Latest } from "../api/latest";
import type { PixelReading } from "../api/types";
import { format } from "../json/numbers";
import { map } from "../state/store";
import { cameraMoves, paintedFrames, partOnStage, placement } from "./stage";

// So many CSS pixels across, a pixel has room for its numbers; of more pixels than so many, nobody reads them.
const leastScale = 48;
const most = 2000;
const pause = 200;
const readings = signal<PixelReading[]>([]);

const part = computed(() => {
  const seen = partOnStage();
  return placement.value.scale >= leastScale && seen.width * seen.height <= most && seen.width > 0 && seen.height > 0 ? seen : null;
});

const asked = new Latest<NonNullable<typeof part.value>>(
  async ({ x, y, width, height }) => {
    readings.value = await get<PixelReading[]>("view/pixels", { x, y, width, height });
    await new Promise((resolve) => setTimeout(resolve, pause));
  },
  (error) => {
    if (!(error instanceof Refusal) && !(error instanceof TypeError)) throw error;
  },
);

effect(() => {
  void paintedFrames.value;
  void map.value;
  if (part.value && !cameraMoves.value) asked.push(part.value);
});

/** The numbers of enlarged pixels, within them. */
export function PixelValues() {
  if (!part.value || cameraMoves.value) return null;
  const { scale, left, top } = placement.value;
  return (
    <div class="pixel-values" aria-hidden="true">
      {readings.value.map(({ x, y, values }) => (
        <span key={`${x},${y}`} style={{ left: `${left + x * scale}px`, top: `${top + y * scale}px`, width: `${scale}px`, height: `${scale}px` }}>
          {values.map((v) => <span>{v === null ? "–" : format(v, 3)}</span>)}
        </span>
      ))}
    </div>
  );
}
