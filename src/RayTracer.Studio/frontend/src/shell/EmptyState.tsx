import { Gallery } from "../files/Gallery";
import { newScene } from "../files/commands";
import { dialog, tourStep } from "../state/store";
import { texts } from "../texts";
import { Button } from "../ui/Button";

/** What is shown while there is no scene: what one can do now. */
export function EmptyState() {
  const t = texts.empty;
  return (
    <section class="empty" aria-label={t.title} data-help="studio#start">
      <div class="empty-head">
        <div>
          <h2>{t.title}</h2>
          <p class="quiet">{t.hint}</p>
        </div>
        <Button label={t.open} icon="open" showLabel kind="primary" onClick={() => (dialog.value = "open")} />
        <Button label={t.new} icon="add" showLabel kind="plain" onClick={() => newScene()} />
        <Button label={t.tour} icon="help" showLabel kind="plain" onClick={() => (tourStep.value = 0)} />
      </div>
      <Gallery />
    </section>
  );
}
