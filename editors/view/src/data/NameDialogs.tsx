// Dialogs for a name: of a copy, and of a new key.

import type { JSX } from "preact";
import { useState } from "preact/hooks";
import { ModalForm } from "./ModalForm";
import type { DataModel } from "./model";
import { placeId } from "./place";
import type { DataEdit } from "./protocol";
import { useChecked } from "./useChecked";

export function DuplicateDialog({ model }: { model: DataModel }): JSX.Element {
  const name = model.activeRow()?.container.name ?? "";
  const [as, setAs] = useState(() => freeName(name, new Set((model.tables.peek()?.data ?? []).map(({ name }) => name.toLowerCase()))));
  const confirm = async (edit: DataEdit): Promise<boolean> => {
    const isDone = await model.edit([edit]);
    if (isDone) {
      model.reveal(as);
    }
    return isDone;
  };
  return <NameForm model={model} title={`Duplicate ${name}`} label="Name of the copy" confirm="Duplicate" text={as} onText={setAs} edit={{ kind: "duplicate", name, as }} onConfirm={confirm} />;
}

export function KeyDialog({ model }: { model: DataModel }): JSX.Element {
  const row = model.activeRow();
  const place = row?.container ?? { name: "" };
  const [key, setKey] = useState("");
  const confirm = async (edit: DataEdit): Promise<boolean> => {
    const isDone = await model.edit([edit]);
    if (isDone) {
      model.expanded.value = new Set([...model.expanded.peek(), placeId(place)]);
    }
    return isDone;
  };
  return <NameForm model={model} title={`Add a key to ${row?.datum.name ?? ""}`} label="Key" confirm="Add Key" text={key} onText={setKey} edit={{ kind: "addKey", place, key }} onConfirm={confirm} />;
}

interface FormProps {
  model: DataModel;
  title: string;
  label: string;
  confirm: string;
  text: string;
  edit: DataEdit;
  onText: (text: string) => void;
  onConfirm: (edit: DataEdit) => Promise<boolean>;
}

function NameForm({ model, title, label, confirm, text, edit, onText, onConfirm }: FormProps): JSX.Element {
  const verdict = useChecked(model, text === "" ? undefined : edit);
  return (
    <ModalForm model={model} title={title} confirm={confirm} reason={text === "" ? `${label}: the field is empty.` : undefined} onConfirm={() => onConfirm(edit)}>
      <label>{label} <input value={text} spellcheck={false} aria-invalid={verdict.message !== ""} aria-describedby="name-verdict" onInput={({ currentTarget }) => onText(currentTarget.value)} /></label>
      <p id="name-verdict" class="verdict" role="status">{verdict.message}</p>
    </ModalForm>
  );
}

/** Returns the next free name: `pPick2` for `pPick`, `pPick10` for `pPick9`. Names in `taken` are in lower case. */
export function freeName(name: string, taken: ReadonlySet<string>): string {
  const [, head = name, digits = ""] = /^(.*?)(\d*)$/.exec(name) ?? [];
  let number = digits === "" ? 2 : Number(digits) + 1;
  while (taken.has(`${head}${number}`.toLowerCase())) {
    number += 1;
  }
  return `${head}${number}`;
}
