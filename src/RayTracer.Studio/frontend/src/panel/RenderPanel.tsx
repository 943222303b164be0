import { post } from "../api/client";
import type { RenderQuality } from "../api/types";
import { setValue } from "../state/edits";
import { attempt } from "../state/messages";
import { renderState } from "../state/store";
import { texts } from "../texts";
import { NumberField } from "../ui/NumberField";
import { Segments } from "../ui/Segments";
import { Select } from "../ui/Select";
import { ThingPanel } from "./ThingPanel";

const sizes: [number, number][] = [[300, 300], [400, 300], [600, 600], [800, 600], [1024, 768], [1280, 720], [1920, 1080], [3840, 2160]];
const t = texts.render;

/** How the picture is rendered: presets for the hurried, every parameter below. */
export function RenderPanel() {
  const render = renderState.value;
  if (!render) return null;
  const set = (change: object) => attempt(() => post("view/render", change));
  const size = `${render.width}x${render.height}`;
  const choices = sizes.map(([w, h]) => ({ value: `${w}x${h}`, label: texts.status.size(w, h) }));
  if (!choices.some((c) => c.value === size)) choices.unshift({ value: size, label: `${texts.status.size(render.width, render.height)}, ${t.ownSize}` });
  const resize = (choice: string) => {
    const [width, height] = choice.split("x").map(Number);
    setValue("/render/width", width!, `size-${choice}`);
    setValue("/render/height", height!, `size-${choice}`);
  };
  return (
    <section aria-label={texts.right.render}>
      <div class="row">
        <div class="row-label"><span>{t.quality}</span></div>
        <div class="row-field">
          <Segments
            label={t.quality}
            value={render.quality ?? "written"}
            choices={[
              { value: "draft", label: t.draft, tip: t.draftWhy },
              { value: "good", label: t.good, tip: t.goodWhy },
              { value: "final", label: t.final, tip: t.finalWhy },
              { value: "written", label: t.written, tip: t.writtenWhy },
            ]}
            onChange={(quality) => set(quality === "written" ? { samples: 0 } : { quality: quality as RenderQuality })}
          />
        </div>
        <span class="no-reset" />
      </div>
      <div class="row">
        <div class="row-label"><label for="size">{t.size}</label></div>
        <div class="row-field"><Select id="size" label={t.size} value={size} choices={choices} onChange={resize} /></div>
        <span class="no-reset" />
      </div>
      <div class="row">
        <div class="row-label" data-tip={t.threadsWhy}><label for="threads">{t.threads}</label></div>
        <div class="row-field">
          <NumberField id="threads" label={t.threads} value={render.threads} bounds={{ minimum: 1, maximum: render.cores, isInteger: true }} onChange={(threads) => set({ threads })} />
        </div>
        <span class="no-reset" />
      </div>
      <div class="row">
        <div class="row-label" data-tip={t.editionWhy}><label for="edition">{t.edition}</label></div>
        <div class="row-field">
          <Select id="edition" label={t.edition} value={render.edition} choices={render.editions.map((value) => ({ value, label: t.editions[value] ?? value }))} onChange={(edition) => set({ edition })} />
        </div>
        <span class="no-reset" />
      </div>
      <h2>{t.more}</h2>
      <ThingPanel pointer="/render" without={[]} />
    </section>
  );
}
