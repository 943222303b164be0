import { map } from "../state/store";
import { texts } from "../texts";
import { showMap } from "../viewport/ViewportBar";
import type { DockTab } from "../shell/Dock";

/** What the picture can show instead of the light, and what that tells. */
function MapsTab() {
  const choices = Object.entries(texts.maps);
  return (
    <div class="maps" role="radiogroup" aria-label={texts.heat.label}>
      {choices.map(([name, [title, why]]) => (
        <label class={map.value === name ? "chosen" : ""} key={name}>
          <input type="radio" name="map" value={name} checked={map.value === name} onChange={() => showMap(name)} />
          <span class={`scale ${name}`} aria-hidden="true" />
          <strong>{title}</strong>
          <span class="quiet">{why}</span>
        </label>
      ))}
    </div>
  );
}

export const tab: DockTab = { id: "maps", order: 3, component: MapsTab };
