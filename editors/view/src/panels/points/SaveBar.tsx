// Undoes changes, and saves changed values, with a confirmation if a file was changed on the disk.

import type { JSX } from "preact";
import { useEffect, useRef, useState } from "preact/hooks";
import { Button } from "../shared/Button";
import type { Answer, Cell, Notice } from "../shared/cell";
import { pointText } from "./edits";

interface Props {
  cell: Cell;
  notice: Notice;
  changed: number;
}

export function SaveBar({ cell, notice, changed }: Props): JSX.Element {
  const [conflict, setConflict] = useState<string[]>([]);
  const [result, setResult] = useState("");
  const save = async (overwrite: boolean): Promise<void> => {
    setConflict([]);
    setResult("");
    const answer = await sent(cell, overwrite);
    const files = textsOf(answer["conflict"]);
    if (files.length > 0 && !overwrite) {
      setConflict(files);
    } else if (answer.error !== null) {
      notice.text.value = answer.error;
    } else {
      notice.text.value = "";
      setResult(savedText(textsOf(answer["files"])));
    }
  };
  const reason = cell.blocked.value ?? (changed === 0 ? "No point was changed." : undefined);
  const undo = cell.undo.value;
  const undoReason = cell.blocked.value ?? (undo === undefined ? "Nothing was changed." : undefined);
  const undoTitle = undo === undefined ? undefined : `Restore ${pointText(undo)} as before its last change`;
  return (
    <div class="save">
      <Button reason={undoReason} title={undoTitle} onPress={() => void notice.send(cell, "undo", {})} onRefused={(text) => (notice.text.value = text)}>Undo{undo === undefined ? "" : ` ${pointText(undo)}`}</Button>
      <Button reason={reason} onPress={() => void save(false)} onRefused={(text) => (notice.text.value = text)}>Save to .dtx{changed > 0 ? ` (${changed})` : ""}</Button>
      <span role="status">{changed === 0 ? result : ""}</span>
      {conflict.length > 0 ? <Question files={conflict} onAnswer={(overwrite) => (overwrite ? void save(true) : setConflict([]))} /> : null}
    </div>
  );
}

async function sent(cell: Cell, overwrite: boolean): Promise<Answer> {
  try {
    return await cell.send("save", { overwrite });
  } catch (fault) {
    return { error: fault instanceof Error ? fault.message : String(fault) };
  }
}

function Question({ files, onAnswer }: { files: string[]; onAnswer: (overwrite: boolean) => void }): JSX.Element {
  const keep = useRef<HTMLButtonElement>(null);
  useEffect(() => keep.current?.focus(), []);
  return (
    <div class="question" role="alertdialog" aria-label="File changed on disk" onKeyDown={({ key }) => { if (key === "Escape") { onAnswer(false); } }}>
      <p>{files.join(", ")} {files.length === 1 ? "was" : "were"} changed on disk since the run has read {files.length === 1 ? "it" : "them"}. Overwrite the values of the changed points?</p>
      <button type="button" ref={keep} onClick={() => onAnswer(false)}>Keep the {files.length === 1 ? "file" : "files"}</button>
      <button type="button" onClick={() => onAnswer(true)}>Overwrite</button>
    </div>
  );
}

function textsOf(value: unknown): string[] {
  return Array.isArray(value) ? value.filter((item) => typeof item === "string") : [];
}

function savedText(files: string[]): string {
  return files.length === 0 ? "Nothing to save." : `Saved ${files.map((file) => file.split(/[\\/]/).at(-1) ?? file).join(", ")}.`;
}
