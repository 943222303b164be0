import { chooseFile } from "../files/choose";
import { setValue } from "../state/edits";
import { texts } from "../texts";
import { Button } from "../ui/Button";
import { TextField } from "../ui/TextField";
import type { FieldProps } from "./FieldContext";

/** A file, written from the scene file's folder where that is known. */
export function FileField({ pointer, effective, label, id }: FieldProps) {
  const choose = () => chooseFile((file) => setValue(pointer, file));
  return (
    <div class="pair">
      <TextField id={id} label={label} value={String(effective ?? "")} placeholder={texts.panel.noneYet} onCommit={(t) => setValue(pointer, t)} />
      <Button label={texts.panel.choose} icon="open" onClick={choose} />
    </div>
  );
}
