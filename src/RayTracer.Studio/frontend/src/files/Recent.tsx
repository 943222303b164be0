import { useEffect, useState } from "preact/hooks";
import { get } from "../api/client";
import { complain } from "../state/messages";
import { dialog, documentState } from "../state/store";
import { texts } from "../texts";
import { Button } from "../ui/Button";
import { openScene } from "./commands";

interface RecentFile {
  path: string;
  name: string;
}

/** Files opened or saved before, and the ways to others. */
export function Recent() {
  const [files, setFiles] = useState<RecentFile[]>([]);
  const path = documentState.value?.path;
  useEffect(() => {
    get<{ files: RecentFile[] }>("file/recent").then((answer) => setFiles(answer.files), complain);
  }, [path]);
  return (
    <div class="recent pad">
      <Button label={texts.files.open} icon="open" showLabel kind="plain" onClick={() => (dialog.value = "open")} />
      <p class="quiet">{texts.files.drop}</p>
      <h2>{texts.files.recent}</h2>
      {files.length === 0 && <p class="quiet">{texts.files.noRecent}</p>}
      <ul aria-label={texts.files.label}>
        {files.map((file) => (
          <li key={file.path}>
            <button type="button" class="list-button" data-tip={file.path} onClick={() => openScene({ path: file.path })}>{file.name}</button>
          </li>
        ))}
      </ul>
    </div>
  );
}
