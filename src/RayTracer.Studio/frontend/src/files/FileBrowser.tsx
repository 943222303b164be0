import { useEffect, useRef, useState } from "preact/hooks";
import { get } from "../api/client";
import { moment, withPrefix } from "../json/numbers";
import type { FolderListing } from "../api/types";
import { complain } from "../state/messages";
import { texts } from "../texts";
import { Button } from "../ui/Button";
import { Icon } from "../ui/Icon";
import { pictureAddress } from "./commands";
import { extensionOf, joinPath } from "./paths";

interface FileBrowserProps {
  start: string | undefined;
  onFolder: (folder: string) => void;
  /** A file was clicked once. */
  onPick: (path: string) => void;
  /** A file was clicked twice, or Enter was pressed on it. */
  onChoose: (path: string) => void;
  picked: string;
  /** Whether pictures and models are looked for, which a scene may name, instead of what can be opened. */
  named?: boolean | undefined;
}

const isPicture = (name: string) => ["png", "jpg", "jpeg", "exr", "hdr", "pfm", "tga", "bmp"].includes(extensionOf(name));

/** A small picture of a file, which is made when it comes into sight; a file that is no picture after all has none. */
function Thumbnail({ path }: { path: string }) {
  const ref = useRef<HTMLSpanElement>(null);
  const [source, setSource] = useState("");
  useEffect(() => {
    const watcher = new IntersectionObserver((seen) => {
      if (!seen.some((entry) => entry.isIntersecting)) return;
      watcher.disconnect();
      pictureAddress("file/thumbnail", { path }).then(setSource, () => undefined);
    });
    watcher.observe(ref.current!);
    return () => watcher.disconnect();
  }, [path]);
  useEffect(() => () => URL.revokeObjectURL(source), [source]);
  return <span ref={ref} class="file-thumbnail">{source && <img src={source} alt="" />}</span>;
}

/** The server's folders and the files in them that the Studio can read. */
export function FileBrowser({ start, onFolder, onPick, onChoose, picked, named }: FileBrowserProps) {
  const [listing, setListing] = useState<FolderListing | null>(null);
  const [typed, setTyped] = useState("");
  const asked = useRef(0);
  const isTyping = useRef(false);
  const shown = useRef("");

  // Only the folder asked for last is shown, and its path never takes the place of what is being typed.
  const go = (path: string | undefined) => {
    const turn = ++asked.current;
    isTyping.current = false;
    get<FolderListing>("file/list", { path, named: named ? "true" : undefined }).then((answer) => {
      if (turn !== asked.current) return;
      setListing(answer);
      if (!isTyping.current) setTyped(answer.path);

      // What is picked stays so when the same folder is read again.
      if (answer.path !== shown.current) onFolder(answer.path);
      shown.current = answer.path;
    }, complain);
  };
  const type = (text: string) => {
    isTyping.current = true;
    setTyped(text);
  };
  useEffect(() => go(start), []);

  const isEmpty = listing && listing.folders.length + listing.files.length === 0;
  return (
    <div class="browser">
      <div class="pair">
        <Button label={texts.dialogs.up} icon="up" disabled={!listing?.parent} onClick={() => go(listing!.parent!)} />
        <input
          type="text"
          class="text"
          aria-label={texts.dialogs.path}
          value={typed}
          spellcheck={false}
          onFocus={() => (isTyping.current = true)}
          onInput={(e) => type(e.currentTarget.value)}
          onKeyDown={(e) => e.key === "Enter" && go(typed || listing?.path)}
        />
        <Button label={texts.dialogs.go} showLabel kind="plain" onClick={() => go(typed || listing?.path)} />
      </div>
      <ul class="listing" aria-label={listing?.path ?? texts.dialogs.folder}>
        {listing?.folders.map((name) => (
          <li key={name}>
            <button type="button" class="list-button" onClick={() => go(joinPath(listing.path, name))}><Icon name="open" />{name}</button>
          </li>
        ))}
        {listing?.files.map(({ name, size, time }) => {
          const path = joinPath(listing.path, name);
          return (
            <li key={name}>
              <button type="button" class="list-button" aria-pressed={path === picked} onClick={() => onPick(path)} onDblClick={() => onChoose(path)}>
                {named && isPicture(name) ? <Thumbnail path={path} /> : <Icon name="scene" />}<span class="name">{name}</span><span class="quiet">{`${withPrefix(size)}B`}</span><time class="quiet" dateTime={time}>{moment(time)}</time>
              </button>
            </li>
          );
        })}
        {isEmpty && <li class="quiet">{named ? texts.dialogs.emptyOfNamed : texts.dialogs.emptyFolder}</li>}
      </ul>
    </div>
  );
}
