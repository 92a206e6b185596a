// Deletes data after their uses have been shown.

import type { JSX } from "preact";
import { useEffect, useState } from "preact/hooks";
import { namesOf } from "./actions";
import { ModalForm } from "./ModalForm";
import type { DataModel } from "./model";
import type { Use } from "./protocol";

export function DeleteDialog({ model }: { model: DataModel }): JSX.Element {
  const [names] = useState(() => namesOf(model.selectedRows()));
  const [uses, setUses] = useState<readonly Use[]>();
  useEffect(() => {
    model.host?.request("uses", { names }).then(setUses, (fault: unknown) => model.report(fault));
  }, [model, names]);
  const what = names.length === 1 ? (names[0] ?? "") : `${names.length} data`;
  return (
    <ModalForm model={model} title={`Delete ${what}`} confirm={uses === undefined || uses.length === 0 ? "Delete" : "Delete Nevertheless"} reason={uses === undefined ? "The uses are being looked up." : undefined} onConfirm={() => model.edit([{ kind: "delete", names }])}>
      {names.length > 1 ? <p class="names">{names.join(", ")}</p> : null}
      <p role="status">{uses === undefined ? "Looking for uses…" : usesText(uses.length)}</p>
      {uses === undefined || uses.length === 0 ? null : (
        <ul class="uses">
          {uses.map((use) => (
            <li key={`${use.uri} ${use.line} ${use.character}`}>
              <button type="button" class="place" onClick={() => model.host?.notify("openUse", { use })}>{use.file}:{use.line + 1}</button> <code>{use.text}</code>
            </li>
          ))}
        </ul>
      )}
    </ModalForm>
  );
}

function usesText(count: number): string {
  return count === 0 ? "Nothing uses it." : `${count} ${count === 1 ? "place uses" : "places use"} it, and would have an unknown name:`;
}
