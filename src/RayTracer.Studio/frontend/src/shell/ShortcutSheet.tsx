import { commands, keysText, type CommandId, type Group } from "../state/commands";
import { dialog } from "../state/store";
import { texts } from "../texts";
import { DialogBox } from "../ui/DialogBox";

const t = texts.shortcuts;

/** All keys on one sheet. */
export function ShortcutSheet() {
  const all = Object.entries(commands) as [CommandId, (typeof commands)[CommandId]][];
  const groups = Object.keys(texts.groups) as Group[];
  return (
    <DialogBox title={t.title} onClose={() => (dialog.value = null)} wide>
      <div class="sheet">
        {groups.map((group) => {
          const own = all.filter(([, c]) => c.group === group && c.keys);
          return own.length === 0 ? null : (
            <section key={group}>
              <h3>{texts.groups[group]}</h3>
              <dl>
                {own.map(([id, c]) => (
                  <div key={id}>
                    <dt>{texts.commands[id][0]}</dt>
                    <dd><kbd>{keysText(c.keys!)}</kbd></dd>
                  </div>
                ))}
              </dl>
            </section>
          );
        })}
        <section>
          <h3>{t.mouse}</h3>
          <dl>
            {t.gestures.map(([gesture, effect]) => (
              <div key={gesture}>
                <dt>{effect}</dt>
                <dd><kbd>{gesture}</kbd></dd>
              </div>
            ))}
          </dl>
        </section>
      </div>
    </DialogBox>
  );
}
