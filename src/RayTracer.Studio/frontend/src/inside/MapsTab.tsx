import type { Vec3 } from "../api/types";
import { map, maps } from "../state/store";
import { texts } from "../texts";
import { showMap } from "../viewport/ViewportBar";
import type { DockTab } from "../shell/Dock";

const css = (color: Vec3) => `rgb(${color.map((c) => Math.round(255 * c)).join(" ")})`;
export const gradient = (scale: Vec3[]) => `linear-gradient(90deg, ${scale.map(css).join(", ")})`;

/** The maps that the picture can show instead of the light, with their meaning. */
function MapsTab() {
  return (
    <div class="maps" role="radiogroup" aria-label={texts.heat.label}>
      {maps.value.map(({ name, title, why, scale }) => (
        <label class={map.value === name ? "chosen" : ""} key={name}>
          <input type="radio" name="map" value={name} checked={map.value === name} onChange={() => showMap(name)} />
          <span class="scale" style={{ background: gradient(scale) }} aria-hidden="true" />
          <strong>{title}</strong>
          <span class="quiet">{why}</span>
        </label>
      ))}
    </div>
  );
}

export const tab: DockTab = { id: "maps", order: 3, help: "studio#look-inside", component: MapsTab };
