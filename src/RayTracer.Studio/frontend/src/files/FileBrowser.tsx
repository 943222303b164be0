import { useEffect, useState } from "preact/hooks";
import { get } from "../api/client";
import { complain } from "../state/messages";
import { texts } from "../texts";
import { Button } from "../ui/Button";
import { Icon } from "../ui/Icon";

export interface FolderListing {
  path: string;
  parent: string | null;
  folders: { name: string; path: string }[];
  files: { name: string; path: string }[];
}

interface FileBrowserProps {
  start: string | undefined;
  onFolder: (folder: string) => void;
  /** A file was clicked once. */
  onPick: (path: string) => void;
  /** A file was clicked twice, or Enter was pressed on it. */
  onChoose: (path: string) => void;
  picked: string;
}

/** The server's folders and the files in them that the Studio can read. */
export function FileBrowser({ start, onFolder, onPick, onChoose, picked }: FileBrowserProps) {
  const [listing, setListing] = useState<FolderListing | null>(null);
  const [typed, setTyped] = useState("");

  const go = (path: string | undefined) =>
    get<FolderListing>("file/list", { path }).then((answer) => {
      setListing(answer);
      setTyped(answer.path);
      onFolder(answer.path);
    }, complain);
  useEffect(() => void go(start), []);

  const isEmpty = listing && listing.folders.length + listing.files.length === 0;
  return (
    <div class="browser">
      <div class="pair">
        <Button label={texts.dialogs.up} icon="undo" disabled={!listing?.parent} onClick={() => void go(listing!.parent!)} />
        <input
          type="text"
          class="text"
          aria-label={texts.dialogs.path}
          value={typed}
          spellcheck={false}
          onInput={(e) => setTyped(e.currentTarget.value)}
          onKeyDown={(e) => e.key === "Enter" && void go(typed)}
        />
        <Button label={texts.dialogs.go} showLabel kind="plain" onClick={() => void go(typed)} />
      </div>
      <ul class="listing" aria-label={listing?.path ?? texts.dialogs.folder}>
        {listing?.folders.map((f) => (
          <li key={f.path}>
            <button type="button" class="list-button" onClick={() => void go(f.path)}><Icon name="open" />{f.name}</button>
          </li>
        ))}
        {listing?.files.map((f) => (
          <li key={f.path}>
            <button
              type="button"
              class="list-button"
              aria-pressed={f.path === picked}
              onClick={() => onPick(f.path)}
              onDblClick={() => onChoose(f.path)}
            >
              <Icon name="scene" />{f.name}
            </button>
          </li>
        ))}
        {isEmpty && <li class="quiet">{texts.dialogs.emptyFolder}</li>}
      </ul>
    </div>
  );
}
