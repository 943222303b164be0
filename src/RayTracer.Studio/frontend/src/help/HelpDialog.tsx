import { useEffect, useRef, useState } from "preact/hooks";
import { get } from "../api/client";
import { Latest } from "../api/latest";
import type { HelpEntry, HelpFinding, HelpFindings, HelpIndex } from "../api/types";
import { complain } from "../state/messages";
import { helpAt } from "../state/store";
import { texts } from "../texts";
import { Button } from "../ui/Button";
import { DialogBox } from "../ui/DialogBox";
import { HelpArticle, type Place } from "./HelpArticle";
import { isLesson, readBeside } from "./lesson";

const t = texts.help;

function PageList({ pages, place, go }: { pages: HelpEntry[]; place: Place; go: (place: Place) => void }) {
  return (
    <>
      {[...new Set(pages.map((p) => p.group))].map((group) => (
        <section key={group} aria-label={group}>
          <h3>{group}</h3>
          <ul>
            {pages.filter((p) => p.group === group).map((p) => (
              <li key={p.id}>
                <button type="button" aria-current={p.id === place.page ? "page" : undefined} data-tip={p.summary || undefined} onClick={() => go({ page: p.id })}>{p.title}</button>
              </li>
            ))}
          </ul>
        </section>
      ))}
    </>
  );
}

function Findings({ findings, go }: { findings: HelpFinding[]; go: (place: Place) => void }) {
  return (
    <>
      <p class="quiet" role="status">{findings.length === 0 ? t.nothing : t.found(findings.length)}</p>
      <ul>
        {findings.map((f) => (
          <li key={`${f.page}#${f.anchor}`}>
            <button type="button" onClick={() => go({ page: f.page, section: f.anchor })}>
              <strong>{f.section}</strong>
              {f.title !== f.section && <span class="quiet"> · {f.title}</span>}
              <span class="excerpt">{f.excerpt}</span>
            </button>
          </li>
        ))}
      </ul>
    </>
  );
}

/** The documentation: pages, search, and links into the gallery. */
export function HelpDialog() {
  const [index, setIndex] = useState<HelpEntry[]>([]);
  const [words, setWords] = useState("");
  const [findings, setFindings] = useState<HelpFinding[] | null>(null);
  const [before, setBefore] = useState<Place[]>([]);
  const search = useRef(new Latest<string>((text) => get<HelpFindings>("help/search", { words: text }).then((answer) => setFindings(answer.findings)), complain));
  const place = helpAt.value!;
  useEffect(() => {
    get<HelpIndex>("help").then((answer) => setIndex(answer.pages), complain);
  }, []);
  const go = (next: Place) => {
    setBefore([...before, place]);
    helpAt.value = next;
  };
  const back = () => {
    helpAt.value = before.at(-1)!;
    setBefore(before.slice(0, -1));
  };
  const find = (text: string) => {
    setWords(text);
    if (!text.trim()) setFindings(null);
    else search.current.push(text);
  };
  return (
    <DialogBox title={t.title} onClose={() => (helpAt.value = null)} full>
      <div class="help">
        <nav aria-label={t.pages}>
          <div class="help-search">
            <Button label={t.back} icon="previous" disabled={before.length === 0} onClick={back} />
            <input type="search" class="text" data-first aria-label={t.search} placeholder={t.search} value={words} onInput={(e) => find(e.currentTarget.value)} />
          </div>
          <div class="help-list" tabIndex={-1}>
            {findings && words.trim() ? <Findings findings={findings} go={go} /> : <PageList pages={index} place={place} go={go} />}
          </div>
        </nav>
        <div class="help-body">
          {isLesson(place.page) && <Button label={t.beside} showLabel kind="plain" icon="scene" onClick={() => readBeside(place.page)} />}
          <HelpArticle place={place} go={go} />
        </div>
      </div>
    </DialogBox>
  );
}
