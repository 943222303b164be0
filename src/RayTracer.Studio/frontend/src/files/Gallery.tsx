import { signal } from "@preact/signals";
import { useEffect, useRef, useState } from "preact/hooks";
import { get } from "../api/client";
import { complain } from "../state/messages";
import { texts } from "../texts";
import { openScene, pictureAddress } from "./commands";

interface GalleryItem {
  id: string;
  name: string;
  summary: string;
}

interface GalleryAnswer {
  groups: { title: string; items: GalleryItem[] }[];
}

const gallery = signal<GalleryAnswer | null>(null);
const thumbnails = new Map<string, Promise<string>>();

// Two at a time: the server renders them, and the picture comes first.
let running = 0;
const waiting: (() => void)[] = [];
async function fetchThumbnail(id: string): Promise<string> {
  if (running >= 2) await new Promise<void>((resolve) => waiting.push(resolve));
  running++;
  try {
    return await pictureAddress("gallery/thumbnail", { id });
  } finally {
    running--;
    waiting.shift()?.();
  }
}

/** A picture that is asked for when it comes into sight. */
function Thumbnail({ id }: { id: string }) {
  const ref = useRef<HTMLSpanElement>(null);
  const [source, setSource] = useState("");
  useEffect(() => {
    const watcher = new IntersectionObserver(([entry]) => {
      if (!entry?.isIntersecting) return;
      watcher.disconnect();
      if (!thumbnails.has(id)) thumbnails.set(id, fetchThumbnail(id));
      thumbnails.get(id)!.then(setSource, () => thumbnails.delete(id));
    });
    watcher.observe(ref.current!);
    return () => watcher.disconnect();
  }, [id]);
  return <span class="thumbnail" ref={ref}>{source && <img src={source} alt="" />}</span>;
}

/** All scenes that come with the program, with pictures that it made itself. */
export function Gallery() {
  useEffect(() => {
    if (!gallery.value) get<GalleryAnswer>("gallery").then((g) => (gallery.value = g), complain);
  }, []);
  if (!gallery.value) return <p class="quiet pad" role="status">{texts.gallery.loading}</p>;
  return (
    <div class="gallery">
      {gallery.value.groups.map((group) => (
        <section aria-label={group.title} key={group.title}>
          <h2>{group.title}</h2>
          <ul>
            {group.items.map((item) => (
              <li key={item.id}>
                <button type="button" aria-label={texts.gallery.open(item.name)} data-tip={item.summary} onClick={() => openScene({ galleryId: item.id })}>
                  <Thumbnail id={item.id} />
                  <span>{item.name}</span>
                </button>
              </li>
            ))}
          </ul>
        </section>
      ))}
    </div>
  );
}
