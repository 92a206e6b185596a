// Search, filters and buttons above the table.

import type { JSX } from "preact";
import { Button } from "../panels/shared/Button";
import { isNamed, namesOf, remove } from "./actions";
import { isKey } from "./cells";
import type { DataModel, Dialog } from "./model";
import { keyOf } from "./rows";
import type { Filter } from "./search";

export const SEARCH = "data-search";

export function ToolBar({ model }: { model: DataModel }): JSX.Element {
  const filter = model.filter.value;
  const change = (part: Partial<Filter>): void => void (model.filter.value = { ...filter, ...part });
  return (
    <div class="row tools" role="toolbar" aria-label="Data">
      <input id={SEARCH} type="search" aria-label="Search names, keys and values of all types" placeholder="Search all types (Ctrl+F)" value={filter.text} onInput={({ currentTarget }) => change({ text: currentTarget.value })} />
      <select aria-label="Access" value={filter.access} onChange={({ currentTarget }) => change({ access: currentTarget.value as Filter["access"] })}>
        <option value="all">Public and private</option>
        <option value="public">Public</option>
        <option value="private">Private</option>
      </select>
      <label><input type="checkbox" checked={filter.isFaultyOnly} onChange={({ currentTarget }) => change({ isFaultyOnly: currentTarget.checked })} /> With findings</label>
      <span class="space" />
      <Buttons model={model} />
    </div>
  );
}

function Buttons({ model }: { model: DataModel }): JSX.Element {
  const row = model.activeRow();
  const { blocked } = model;
  const refused = (reason: string): void => void (model.notice.text.value = reason);
  const open = (dialog: Dialog) => () => void (model.dialog.value = dialog);
  const needsDatum = row === undefined ? "Select data first." : undefined;
  const needsKeys = row?.datum.container === "collection" ? undefined : "Select a collection or one of its keys first.";
  const text = (): void => {
    const key = row && keyOf(row);
    model.host?.notify("openText", { ...(row !== undefined && { name: row.container.name }), ...(key !== undefined && row?.kind !== "field" && { key }) });
  };
  return (
    <>
      <Button title="Add data (Insert)" reason={blocked.value} onPress={open("add")} onRefused={refused}>Add…</Button>
      <Button title="Copy the selected data under another name" reason={blocked.value ?? needsDatum} onPress={open("duplicate")} onRefused={refused}>Duplicate…</Button>
      <Button title="Rename the selected data or key (F2 on its name)" reason={blocked.value ?? needsDatum ?? (row !== undefined && isNamed(row) ? undefined : "Only data and keys of collections have names.")} onPress={() => row !== undefined && (model.editing.value = { row: row.id, column: "#name", text: isKey(row) ? (keyOf(row) ?? "") : row.label })} onRefused={refused}>Rename</Button>
      <Button title="Add a key to the collection (Insert)" reason={blocked.value ?? needsKeys} onPress={open("addKey")} onRefused={refused}>Add Key…</Button>
      <Button title="Delete the selected data or keys (Delete on their names)" reason={blocked.value ?? needsDatum} onPress={() => void remove(model)} onRefused={refused}>Delete{deletedText(model)}</Button>
      <Button title="Show the selected data in the file" onPress={text}>Text</Button>
    </>
  );
}

function deletedText(model: DataModel): string {
  const rows = model.selectedRows();
  const areKeys = rows.length > 0 && rows.every(isKey);
  return areKeys ? (rows.length === 1 ? " Key" : ` ${rows.length} Keys`) : namesOf(rows).length > 1 ? ` ${namesOf(rows).length}…` : "…";
}
