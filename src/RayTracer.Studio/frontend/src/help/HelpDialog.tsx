import { useEffect, useLayoutEffect, useRef, useState } from "preact/hooks";
import { get } from "../api/client";
import { Latest } from "../api/latest";
import type { HelpEntry, HelpFinding, HelpFindings, HelpIndex, HelpPage } from "../api/types";
import { openScene, pictureAddress } from "../files/commands";
import { complain } from "../state/messages";
import { helpAt } from "../state/store";
import { texts } from "../texts";
import { Button } from "../ui/Button";
import { DialogBox } from "../ui/DialogBox";
import { targetOf } from "./links";

const t = texts.help;

type Place = NonNullable<typeof helpAt.value>;

/** Shows pictures, and makes of links what they can be here. */
function dress(article: HTMLElement): void {
  for (const picture of article.querySelectorAll<HTMLImageElement>("img[data-picture]")) {
    // What is not shipped has its words, which stand in its place.
    const show = (source: string) => {
      picture.onload = () => URL.revokeObjectURL(source);
      picture.src = source;
    };
    pictureAddress("help/picture", { path: picture.dataset.picture! }).then(show, () => picture.replaceWith(picture.alt));
  }
  for (const link of article.querySelectorAll("a")) {
    const target = targetOf(link.getAttribute("href") ?? "");
    if (target.kind === "web") [link.target, link.rel] = ["_blank", "noreferrer"];
    if (target.kind === "scene") link.dataset.tip = t.openScene;
    if (target.kind === "file") link.replaceWith(...link.childNodes);
  }
  for (const code of article.querySelectorAll("pre")) code.tabIndex = 0;
}

function Page({ place, go }: { place: Place; go: (place: Place) => void }) {
  const [page, setPage] = useState<HelpPage | null>(null);
  const article = useRef<HTMLElement>(null);
  useEffect(() => {
    get<HelpPage>("help/page", { id: place.page }).then(setPage, complain);
  }, [place.page]);
  useLayoutEffect(() => {
    if (page?.id === place.page) dress(article.current!);
  }, [page]);
  useLayoutEffect(() => {
    if (page?.id !== place.page) return;
    const section = place.section && article.current!.querySelector(`#${CSS.escape(place.section)}`);
    if (section) section.scrollIntoView();
    else article.current!.scrollTop = 0;
  }, [page, place]);
  const follow = (e: MouseEvent) => {
    const link = (e.target as Element).closest("a");
    const target = link && targetOf(link.getAttribute("href") ?? "");
    if (!target || target.kind === "web") return;
    e.preventDefault();
    if (target.kind === "page") go(target);
    else if (target.kind === "section") go({ page: place.page, section: target.section });
    else if (target.kind === "scene") {
      helpAt.value = null;
      openScene({ galleryId: target.galleryId });
    }
  };
  return <article class="help-page" ref={article} tabIndex={0} aria-label={page?.title ?? t.loading} onClick={follow} dangerouslySetInnerHTML={{ __html: page?.html ?? "" }} />;
}

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
            <Button label={t.back} icon="undo" disabled={before.length === 0} onClick={back} />
            <input type="search" class="text" aria-label={t.search} placeholder={t.search} value={words} onInput={(e) => find(e.currentTarget.value)} />
          </div>
          <div class="help-list" tabIndex={-1}>
            {findings && words.trim() ? <Findings findings={findings} go={go} /> : <PageList pages={index} place={place} go={go} />}
          </div>
        </nav>
        <Page place={place} go={go} />
      </div>
    </DialogBox>
  );
}
