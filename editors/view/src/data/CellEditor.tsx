// Field in which the text of a cell is typed.

import type { JSX, TargetedKeyboardEvent } from "preact";
import { useLayoutEffect, useRef, useState } from "preact/hooks";
import { setCell } from "./actions";
import { contentOf, editOf } from "./cells";
import type { GridColumn } from "./columns";
import type { DataModel, Editing } from "./model";
import type { Column, DataEdit } from "./protocol";
import type { Row } from "./rows";
import { useChecked } from "./useChecked";

interface Props {
  model: DataModel;
  editing: Editing;
  row: Row;
  column: GridColumn;
  /** Returns the focus to the table, and moves by cells. */
  onEnd: (down: number, right: number) => void;
}

type Field = HTMLInputElement | HTMLSelectElement;

export function CellEditor({ model, editing, row, column, onEnd }: Props): JSX.Element {
  const content = contentOf(row, column);
  const [text, setText] = useState(editing.text);
  const field = useRef<Field>(null);
  const isEnding = useRef(false);
  const verdict = useChecked(model, checkedEdit(row, column, text));
  // Synchronous, so that the next key reaches the field.
  useLayoutEffect(() => {
    const input = field.current;
    input?.focus({ preventScroll: true });
    if (input instanceof HTMLInputElement && editing.text === content.text) {
      input.select();
    }
  }, []);
  const end = (down: number, right: number): void => {
    isEnding.current = true;
    model.editing.value = undefined;
    onEnd(down, right);
  };
  const commit = async (down: number, right: number): Promise<void> => {
    isEnding.current = true;
    if (await setCell(model, row, column, text)) {
      end(down, right);
    } else {
      isEnding.current = false;
      field.current?.focus();
    }
  };
  const pressed = (event: TargetedKeyboardEvent<Field>): void => {
    const move = { Enter: [event.shiftKey ? -1 : 1, 0], Tab: [0, event.shiftKey ? -1 : 1] }[event.key];
    event.stopPropagation();
    if (event.key === "Escape" || move !== undefined) {
      event.preventDefault();
      if (move === undefined) {
        end(0, 0);
      } else {
        void commit(move[0] ?? 0, move[1] ?? 0);
      }
    }
  };
  const left = (): void => {
    // The user clicked elsewhere, or the window lost the focus: the text is applied if it is valid.
    if (!isEnding.current && document.hasFocus()) {
      isEnding.current = true;
      void setCell(model, row, column, text).then(() => (model.editing.value = undefined));
    }
  };
  const label = `${row.label} ${content.column?.title ?? column.title}`.trim();
  const common = {
    "class": "cell-editor", "aria-label": label, "aria-invalid": verdict.message !== "", "aria-describedby": "cell-verdict", value: text, onKeyDown: pressed, onBlur: left,
    onInput: ({ currentTarget }: { currentTarget: Field }) => setText(currentTarget.value),
  };
  return (
    <>
      <Input common={common} column={content.column} field={field} />
      <p id="cell-verdict" class="verdict" role="status">{verdict.message}</p>
    </>
  );
}

function Input({ common, column, field }: { common: object; column: Column | undefined; field: { current: Field | null } }): JSX.Element {
  const take = (element: Field | null): void => void (field.current = element);
  if (column?.kind === "choice") {
    return <select {...common} ref={take}>{column.choices.map((choice) => <option key={choice} value={choice}>{choice}</option>)}</select>;
  }
  const choices = column?.choices ?? [];
  return (
    <>
      <input {...common} ref={take} spellcheck={false} autocomplete="off" inputMode={column?.kind === "number" ? "decimal" : "text"} list={choices.length > 0 ? "cell-choices" : undefined} />
      {choices.length > 0 ? <datalist id="cell-choices">{choices.map((choice) => <option key={choice} value={choice} />)}</datalist> : null}
    </>
  );
}

/** Returns the edit to check. A new name is checked only when it is applied, because other files change too. */
function checkedEdit(row: Row, column: GridColumn, text: string): DataEdit | string | undefined {
  const isUnchanged = contentOf(row, column).text === text;
  return isUnchanged || (column.kind === "name" && row.kind === "datum") ? undefined : editOf(row, column, text);
}
