// Row in which a variable is added.

import type { JSX } from "preact";
import { useLayoutEffect, useRef, useState } from "preact/hooks";
import { literalOf } from "./edits";
import type { List } from "./model";

/** Variable that is not declared yet. */
export interface Draft {
  name: string;
  type: string;
  /** Passing of a parameter, or size of a local. */
  shape: string;
  /** Expression that callers pass. */
  argument: string;
}

interface NewVariableProps {
  list: List;
  types: readonly string[];
  shapes: readonly string[] | undefined;
  /** Identifier of the message about it, if there is one. */
  fault: string | undefined;
  onAdd: (draft: Draft) => void;
  onCancel: () => void;
}

export function NewVariable({ list, types, shapes, fault, onAdd, onCancel }: NewVariableProps): JSX.Element {
  const [draft, setDraft] = useState<Draft>({ name: "", type: "num", shape: shapes?.[0] ?? "1", argument: literalOf("num") });
  const name = useRef<HTMLInputElement>(null);
  useLayoutEffect(() => name.current?.focus(), []);
  const noun = list === "parameters" ? "new parameter" : "new local";
  const change = (part: Partial<Draft>): void => setDraft({ ...draft, ...part });
  const retype = (type: string): void => {
    const isLiteral = draft.argument === literalOf(draft.type);
    change({ type, argument: isLiteral ? literalOf(type) : draft.argument });
  };
  const keys = (event: KeyboardEvent): void => {
    if (event.key === "Escape") {
      onCancel();
    } else if (event.key === "Enter" && event.target instanceof HTMLInputElement) {
      onAdd(draft);
    }
  };
  const text = (part: "name" | "shape" | "argument", label: string): JSX.Element => (
    <input
      type="text" spellcheck={false} data-field={part} aria-label={label} aria-describedby={fault}
      ref={part === "name" ? name : null} value={draft[part]} onInput={({ currentTarget }) => change({ [part]: currentTarget.value })}
    />
  );
  const choice = (label: string, value: string, choices: readonly string[], onChoose: (chosen: string) => void): JSX.Element => (
    <select aria-label={label} value={value} onChange={({ currentTarget }) => onChoose(currentTarget.value)}>
      {choices.map((choice) => <option key={choice} value={choice}>{choice}</option>)}
    </select>
  );
  const shape = shapes === undefined
    ? text("shape", `Size of the ${noun}`)
    : choice(`Passing of the ${noun}`, draft.shape, shapes, (shape) => change({ shape }));
  return (
    <>
      <tr role="row" class="new" onKeyDown={keys}>
        <td role="cell" class="name">{text("name", `Name of the ${noun}`)}</td>
        <td role="cell" class="type">{choice(`Type of the ${noun}`, draft.type, types, retype)}</td>
        <td role="cell" class="shape">{shape}</td>
        <td role="cell" class="uses" />
        <td role="cell" class="buttons">
          <button type="button" class="primary" onClick={() => onAdd(draft)}>Add</button>
          <button type="button" aria-label="Cancel" title="Cancel (Escape)" onClick={onCancel}>✕</button>
        </td>
      </tr>
      {list === "parameters" && (
        <tr role="row" class="argument" onKeyDown={keys}>
          <td role="cell" colSpan={5}><label>Callers pass {text("argument", "Expression that callers pass")}</label></td>
        </tr>
      )}
    </>
  );
}
