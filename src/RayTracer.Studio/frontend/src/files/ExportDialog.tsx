import { useEffect, useState } from "preact/hooks";
import { get } from "../api/client";
import type { PictureFormat } from "../api/types";
import { attempt } from "../state/messages";
import { dialog, hidden, isOwnView, maps, renderState } from "../state/store";
import { texts } from "../texts";
import { Button } from "../ui/Button";
import { DialogBox } from "../ui/DialogBox";
import { Select } from "../ui/Select";
import { downloadPicture, savePicture, sceneName } from "./commands";
import { SaveAsDialog } from "./FileDialogs";
import { nameOf, withExtension } from "./paths";

const t = texts.dialogs;

/** How to write the picture, then where. */
export function ExportDialog() {
  const [formats, setFormats] = useState<PictureFormat[]>([]);
  const [format, setFormat] = useState("png");
  const [bits, setBits] = useState("8");
  const [layers, setLayers] = useState<string[]>([]);
  const [isTransparent, setTransparent] = useState(false);
  const [seenFrom, setSeenFrom] = useState<"scene" | "view">("scene");
  const [isNaming, setNaming] = useState(false);
  const close = () => (dialog.value = null);
  const about = formats.find((f) => f.value === format);
  const hasAlpha = (about?.hasAlpha ?? false) && renderState.value?.edition === renderState.value?.editions[0];
  const options = { format, bitDepth: Number(bits), layers: about?.hasLayers ? layers : [], asSeen: seenFrom === "view", transparent: hasAlpha && isTransparent };
  const isOther = isOwnView() || (hidden.value?.length ?? 0) > 0;
  const isElsewhere = (isOther && seenFrom === "scene") || options.transparent;
  useEffect(() => void attempt(async () => setFormats((await get<{ formats: PictureFormat[] }>("picture/formats")).formats)), []);

  if (isNaming) {
    const fileName = nameOf(withExtension(sceneName(), format));
    return <SaveAsDialog title={t.exportTitle} fileName={fileName} onClose={close} onSave={(path) => savePicture(path, options)} />;
  }

  const toggle = (layer: string, isOn: boolean) => setLayers(isOn ? [...layers, layer] : layers.filter((l) => l !== layer));
  const buttons = (
    <>
      <Button label={t.cancel} showLabel kind="plain" onClick={close} />
      <Button label={t.download} showLabel kind="plain" tip={isElsewhere ? t.downloadOfView : undefined} disabled={isElsewhere || (about?.isFilm ?? false)} onClick={() => (close(), downloadPicture(options))} />
      <Button label={t.exportTo} showLabel kind="primary" onClick={() => setNaming(true)} />
    </>
  );
  return (
    <DialogBox title={t.exportTitle} onClose={close} buttons={buttons} help="image-formats">
      <p class="quiet">{t.formatWhy}</p>
      {isOther && (
        <>
          <label class="line">
            <span>{t.exportCamera}</span>
            <Select label={t.exportCamera} value={seenFrom} choices={(["scene", "view"] as const).map((c) => ({ value: c, label: t.exportCameras[c] }))} onChange={(c) => setSeenFrom(c as "scene" | "view")} />
          </label>
          <p class="quiet">{t.exportCameraWhy}</p>
        </>
      )}
      <label class="line">
        <span>{t.format}</span>
        <Select label={t.format} value={format} choices={formats} onChange={setFormat} />
      </label>
      {about?.hasDepth && (
        <label class="line">
          <span>{t.bits}</span>
          <Select label={t.bits} value={bits} choices={["8", "16"].map((b) => ({ value: b, label: b }))} onChange={setBits} />
        </label>
      )}
      {hasAlpha && (
        <label class="check" data-tip={t.transparentWhy}>
          <input type="checkbox" checked={isTransparent} onChange={(e) => setTransparent(e.currentTarget.checked)} />
          {t.transparent}
        </label>
      )}
      {about?.hasLayers && (
        <fieldset>
          <legend>{t.layers}</legend>
          {maps.value.filter((map) => !map.isLight).map(({ name, title }) => (
            <label class="check" key={name}>
              <input type="checkbox" checked={layers.includes(name)} onChange={(e) => toggle(name, e.currentTarget.checked)} />
              {title}
            </label>
          ))}
        </fieldset>
      )}
    </DialogBox>
  );
}
