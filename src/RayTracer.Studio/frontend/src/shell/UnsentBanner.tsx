import { isOf, forgetUnsent, unsentBefore, type Unsent } from "../editor/unsent";
import { newScene, openScene } from "../files/commands";
import { moment } from "../json/numbers";
import { bottomOpen, bottomTab } from "../state/settings";
import { connection, documentState, mergeWanted } from "../state/store";
import { texts } from "../texts";
import { Button } from "../ui/Button";

function merge(unsent: Unsent, isWhole = false): void {
  unsentBefore.value = unsentBefore.value.filter((u) => u !== unsent);
  bottomOpen.value = true;
  bottomTab.value = "source";
  mergeWanted.value = { unsent, isWhole };
}

/** Offers what earlier windows could not send, one at a time: first of the document that is open, then of others, which are opened for it. */
export function UnsentBanner() {
  const doc = documentState.value;
  const all = unsentBefore.value;
  const own = doc && all.find((u) => isOf(u, doc));
  const unsent = own ?? all[0];
  if (!unsent || !doc || connection.value !== "open") return null;
  const t = texts.connection;
  return (
    <div class="banner" role="status">
      <span>{t.unsent(unsent.name, moment(unsent.time))}</span>
      {own && <Button label={t.merge} showLabel kind="primary" onClick={() => merge(own)} />}
      {!own && unsent.path !== null && <Button label={t.openFirst(unsent.name)} showLabel kind="primary" onClick={() => openScene({ path: unsent.path! })} />}
      {!own && unsent.path === null && <Button label={t.asNew} showLabel kind="primary" onClick={() => newScene(() => merge(unsent, true))} />}
      <Button label={t.discard} showLabel kind="plain" onClick={() => forgetUnsent(unsent)} />
    </div>
  );
}
