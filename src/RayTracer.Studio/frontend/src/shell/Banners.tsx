import { discardRecovery, openScene } from "../files/commands";
import { moment } from "../json/numbers";
import { connection, recoveries } from "../state/store";
import { texts } from "../texts";
import { Button } from "../ui/Button";

/** What must not be overlooked: a lost connection, and work that can be recovered, one at a time. */
export function Banners() {
  const t = texts.recovery;
  return (
    <>
      {connection.value === "lost" && <p class="banner error" role="alert">{texts.connection.lost}</p>}
      {connection.value === "refused" && <p class="banner error" role="alert">{texts.connection.refused}</p>}
      {(recoveries.value ?? []).slice(0, 1).map((r) => (
        <div class="banner" role="status" key={r.id}>
          <span>{(r.isFilm ? t.film : t.text)(r.name, moment(r.time))}</span>
          <Button label={t.open} showLabel kind="primary" onClick={() => openScene({ recoveryId: r.id })} />
          <Button label={t.discard} showLabel kind="plain" onClick={() => discardRecovery(r.id)} />
        </div>
      ))}
    </>
  );
}
