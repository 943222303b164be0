import { parent } from "../json/pointer";
import { isSurrounded } from "../outliner/rows";
import { rightTab } from "../state/settings";
import { outline, schema, selection } from "../state/store";
import { texts } from "../texts";
import { Tabs } from "../ui/Tabs";
import { ColorNames } from "./ColorField";
import { EnvironmentPanel } from "./EnvironmentPanel";
import { RenderPanel } from "./RenderPanel";
import { ThingPanel } from "./ThingPanel";

const hasOwnTab = new Set(["", "/camera", "/render"]);

function SelectedThing() {
  const pointer = selection.value;
  if (pointer === null || hasOwnTab.has(pointer) || (parent(pointer) === "" && !schema.value)) return <p class="quiet pad">{texts.panel.nothing}</p>;
  return <ThingPanel pointer={pointer} key={pointer} />;
}

function World() {
  const scene = schema.value?.sections.scene;
  // What colours the whole scene; the lists have their own places in the outliner.
  const own = scene?.parameters.filter((p) => ["color", "texture", "number", "choice", "boolean"].includes(p.kind.toLowerCase())) ?? [];
  // An environment takes the place of the background.
  const hidden = isSurrounded(outline.value) ? "background" : null;
  return (
    <>
      {own.map((p) => (p.key === hidden ? null : <ThingPanel pointer={`/${p.key}`} key={p.key} />))}
      <EnvironmentPanel />
    </>
  );
}

/** The right pane. */
export function PropertyPanel() {
  return (
    <>
      <ColorNames />
      <Tabs
        label={texts.right.label}
        chosen={rightTab}
        tabs={[
          { id: "object", label: texts.right.object, help: "studio#things", render: () => <SelectedThing /> },
          { id: "camera", label: texts.right.camera, help: "cameras-and-filters", render: () => <ThingPanel pointer="/camera" without={[]} /> },
          { id: "render", label: texts.right.render, help: "scene-format#render", render: () => <RenderPanel /> },
          { id: "world", label: texts.right.world, help: "scene-format#environments", render: () => <World /> },
        ]}
      />
    </>
  );
}
