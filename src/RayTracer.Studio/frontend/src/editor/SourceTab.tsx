import type { ComponentType } from "preact";
import { useEffect, useState } from "preact/hooks";
import { documentState } from "../state/store";
import { texts } from "../texts";
import { Icon } from "../ui/Icon";
import { showRange } from "./show";
import type { DockTab } from "../shell/Dock";

/** The editor, loaded when it is first looked at, and below it what is wrong with the text. */
function SourceTab() {
  const [Editor, setEditor] = useState<ComponentType | null>(null);
  useEffect(() => void import("./SourceEditor").then((m) => setEditor(() => m.default)), []);
  const diagnostics = documentState.value?.diagnostics ?? [];
  return (
    <div class="source-tab">
      {Editor ? <Editor /> : <div class="source" />}
      {diagnostics.length > 0 && (
        <ul class="problems" aria-label={texts.editor.problems}>
          {diagnostics.map((d) => (
            <li key={`${d.from}${d.message}`}>
              <button type="button" class={`list-button ${d.severity}`} onClick={() => showRange(d.from, d.to)}>
                <Icon name="warning" />
                <span class="hidden-text">{texts.editor.goTo}</span>
                <span class="place">{d.line}:{d.column}</span>
                <span>{d.message}</span>
              </button>
            </li>
          ))}
        </ul>
      )}
    </div>
  );
}

export const tab: DockTab = { id: "source", order: 1, help: "studio#the-source", component: SourceTab, badge: () => documentState.value?.diagnostics.length };
