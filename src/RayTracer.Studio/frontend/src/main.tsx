import { effect } from "@preact/signals";
import { render } from "preact";
import { sayGoodbye, shareToken } from "./api/client";
import { followAddress } from "./inside/address";
import { App } from "./shell/App";
import { follow } from "./state/follow";
import { reportFaults } from "./state/messages";
import { tourSeen } from "./state/settings";
import { documentState, isFresh, jobs, tourStep } from "./state/store";
import { followKeys } from "./timeline/keys";
import "./styles/base.css";
import "./styles/shell.css";
import "./styles/controls.css";
import "./styles/panels.css";
import "./styles/viewport.css";
import "./styles/inside.css";
import "./styles/timeline.css";
import "./styles/dialogs.css";

// Who comes by a link wants to see what it leads to.
const hasTarget = location.hash.length > 1;

reportFaults();
shareToken();
follow();
followKeys();
followAddress();

addEventListener("pagehide", sayGoodbye);
addEventListener("beforeunload", (e) => {
  if (documentState.value?.isDirty || jobs.value?.length) e.preventDefault();
});

// New users are shown around, as soon as there is something to see.
const stopWaiting = effect(() => {
  if (!documentState.value || isFresh.value) return;
  if (!tourSeen.peek() && !hasTarget) tourStep.value = 0;
  queueMicrotask(() => stopWaiting());
});

render(<App />, document.getElementById("app")!);
