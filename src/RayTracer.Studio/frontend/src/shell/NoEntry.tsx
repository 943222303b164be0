import { token } from "../api/client";
import { texts } from "../texts";

/** The page that was opened without the secret of this launch, or with an old one: what to do, and nothing else. */
export function NoEntry() {
  const t = texts.noEntry;
  return (
    <main class="no-entry">
      <h1>{t.title}</h1>
      <p>{token ? t.old : t.without}</p>
      <p>{t.what}</p>
      <pre>{t.command}</pre>
      <p class="quiet">{t.why}</p>
    </main>
  );
}
