import { useEffect, useLayoutEffect, useRef, useState } from "preact/hooks";
import { get } from "../api/client";
import type { HelpPage } from "../api/types";
import { openScene, pictureAddress } from "../files/commands";
import { complain } from "../state/messages";
import { helpAt } from "../state/store";
import { texts } from "../texts";
import { tryChanges } from "./lesson";
import { targetOf } from "./links";

const t = texts.help;

export type Place = NonNullable<typeof helpAt.value>;

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
    if (target.kind === "try") {
      link.dataset.tip = t.tryThis;
      link.classList.add("try");
    }
    if (target.kind === "file") link.replaceWith(...link.childNodes);
  }
  for (const code of article.querySelectorAll("pre")) code.tabIndex = 0;
}

/** A page, with pictures, and links that do what they can here. */
export function HelpArticle({ place, go }: { place: Place; go: (place: Place) => void }) {
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
    else if (target.kind === "try") tryChanges(place.page, target.changes);
    else if (target.kind === "scene") {
      helpAt.value = null;
      openScene({ galleryId: target.galleryId });
    }
  };
  if (!page) return <p class="quiet pad" role="status">{t.loading} …</p>;
  return <article class="help-page" ref={article} tabIndex={0} aria-label={page.title} onClick={follow} dangerouslySetInnerHTML={{ __html: page.html }} />;
}
