// Dialogs of the page.

import type { JSX } from "preact";
import { AddDialog } from "./AddDialog";
import { DeleteDialog } from "./DeleteDialog";
import type { DataModel } from "./model";
import { DuplicateDialog, KeyDialog } from "./NameDialogs";

export function Dialogs({ model }: { model: DataModel }): JSX.Element | null {
  switch (model.dialog.value) {
    case "add": return <AddDialog model={model} />;
    case "duplicate": return <DuplicateDialog model={model} />;
    case "addKey": return <KeyDialog model={model} />;
    case "delete": return <DeleteDialog model={model} />;
    case undefined: return null;
  }
}
