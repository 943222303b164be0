import { post } from "../api/client";
import { attempt } from "../state/messages";
import { documentState, opening } from "../state/store";
import { texts } from "../texts";
import { Button } from "../ui/Button";
import { isOwnPicture } from "./stage";

const t = texts.opening;

/** What is opened, how far that is, and a way back, until its own picture is there; or that nothing can be shown of it. */
export function OpeningNote() {
  const doc = documentState.value;
  const isAsked = opening.value !== null;
  if (!doc || (!isAsked && isOwnPicture.value)) return null;
  const isBuilt = doc.builtRevision === doc.revision;
  if (!isAsked && isBuilt && !doc.hasPicture) return <p class="chip warn" role="status">{t.nothing(doc.name)}</p>;
  const step = isAsked || doc.reading ? t.reading(doc.reading ?? opening.value ?? "") : isBuilt ? t.rendering : t.building;
  return (
    <div class="opening" role="status" data-handle="opening">
      <strong>{t.title(opening.value ?? doc.name)}</strong>
      <span class="quiet">{step}</span>
      <progress aria-label={step} />
      {(isAsked || !doc.hasPicture) && <Button label={texts.dialogs.cancel} showLabel kind="plain" onClick={() => attempt(() => post("file/cancel"))} />}
    </div>
  );
}
