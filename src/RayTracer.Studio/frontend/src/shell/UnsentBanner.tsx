import { useState } from "preact/hooks";
import { forgetUnsent, readUnsent } from "../editor/unsent";
import { moment } from "../json/numbers";
import { bottomOpen, bottomTab } from "../state/settings";
import { connection, documentState, mergeWanted } from "../state/store";
import { texts } from "../texts";
import { Button } from "../ui/Button";

/** Offers what an earlier window of this document could not send. */
export function UnsentBanner() {
  const [unsent, setUnsent] = useState(readUnsent);
  if (!unsent || connection.value !== "open" || documentState.value?.name !== unsent.name) return null;
  const t = texts.connection;
  const merge = () => {
    setUnsent(null);
    bottomOpen.value = true;
    bottomTab.value = "source";
    mergeWanted.value = unsent;
  };
  const discard = () => {
    setUnsent(null);
    forgetUnsent();
  };
  return (
    <div class="banner" role="status">
      <span>{t.unsent(unsent.name, moment(unsent.time))}</span>
      <Button label={t.merge} showLabel kind="primary" onClick={merge} />
      <Button label={t.discard} showLabel kind="plain" onClick={discard} />
    </div>
  );
}
