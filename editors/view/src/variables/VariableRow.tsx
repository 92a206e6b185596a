// Row of a table: the fields of a variable, its uses, and the buttons that move or remove it.

import type { JSX } from "preact";
import { ChoiceField, TextField } from "./fields";
import type { List, VariablesModel } from "./model";

/** Actions of a row when the user changes something. The results are whether the change was applied. */
export interface RowActions {
  rename: (name: string) => Promise<boolean>;
  retype: (type: string) => Promise<boolean>;
  /** The last field: passing of a parameter, or size of a local. */
  reshape: (shape: string) => Promise<boolean>;
  move: (by: number) => void;
  remove: () => void;
}

interface RowProps {
  model: VariablesModel;
  list: List;
  index: number;
  count: number;
  name: string;
  type: string;
  types: readonly string[];
  /** Passing of a parameter, with its choices, or size of a local. */
  shape: string;
  shapes: readonly string[] | undefined;
  uses: number;
  actions: RowActions;
}

const NOUN: Record<List, string> = { parameters: "parameter", locals: "local" };

export function VariableRow({ model, list, index, count, name, type, types, shape, shapes, uses, actions }: RowProps): JSX.Element {
  const refusal = model.refusal.value;
  const isRefused = refusal?.list === list && refusal.index === index;
  const fault = isRefused ? `${list}-${index}-reason` : undefined;
  const what = `${NOUN[list]} ${name}`;
  const common = { fault, onRevert: () => model.forgive() };
  const keys = (event: KeyboardEvent): void => {
    const action = event.altKey ? ACTIONS[event.key] : undefined;
    if (action !== undefined) {
      event.preventDefault();
      action(actions);
    }
  };
  const last = shapes === undefined
    ? <TextField field="shape" label={`Size of ${what}`} value={shape} onCommit={actions.reshape} {...common} />
    : <ChoiceField field="shape" label={`Passing of ${what}`} value={shape} choices={shapes} onCommit={actions.reshape} {...common} />;
  return (
    <>
      <tr role="row" data-list={list} data-index={index} class={uses === 0 ? "unused" : undefined} onKeyDown={keys}>
        <td role="cell" class="name"><TextField field="name" label={`Name of ${what}`} value={name} onCommit={actions.rename} {...common} /></td>
        <td role="cell" class="type">
          <ChoiceField field="type" label={`Type of ${what}`} value={type} choices={types} onCommit={actions.retype} {...common} />
        </td>
        <td role="cell" class="shape">{last}</td>
        <td role="cell" class="uses" title="Number of uses in the code">{uses === 0 ? "unused" : uses}</td>
        <td role="cell" class="buttons">
          <RowButton field="up" label={`Move ${what} up`} keys="Alt+Up" sign="↑" reason={index === 0 ? "It is the first." : undefined} onPress={() => actions.move(-1)} />
          <RowButton field="down" label={`Move ${what} down`} keys="Alt+Down" sign="↓" reason={index + 1 === count ? "It is the last." : undefined} onPress={() => actions.move(1)} />
          <RowButton field="remove" label={`Remove ${what}`} keys="Alt+Delete" sign="✕" onPress={actions.remove} />
        </td>
      </tr>
      {isRefused && <Reason id={fault} reason={refusal.reason} />}
    </>
  );
}

const ACTIONS: Record<string, (actions: RowActions) => void> = {
  ArrowUp: ({ move }) => move(-1),
  ArrowDown: ({ move }) => move(1),
  Delete: ({ remove }) => remove(),
};

/** Formats a reason from the server, with a capital letter and a full stop. */
export function sentence(reason: string): string {
  return (reason.charAt(0).toUpperCase() + reason.slice(1)).replace(/[^.]$/, "$&.");
}

/** Shows the reason why an edit of the row above was rejected. */
export function Reason({ id, reason }: { id: string | undefined; reason: string }): JSX.Element {
  return (
    <tr role="row" class="reason">
      <td role="cell" colSpan={5}><p id={id} role="alert">{sentence(reason)}</p></td>
    </tr>
  );
}

interface RowButtonProps {
  field: string;
  label: string;
  keys: string;
  sign: string;
  reason?: string | undefined;
  onPress: () => void;
}

/** Button that keeps the focus while it is disabled. */
function RowButton({ field, label, keys, sign, reason, onPress }: RowButtonProps): JSX.Element {
  const press = (): void => (reason === undefined ? onPress() : undefined);
  return (
    <button
      type="button"
      data-field={field}
      aria-label={label}
      aria-disabled={reason === undefined ? undefined : true}
      title={reason ?? `${label} (${keys})`}
      onClick={press}
    >
      {sign}
    </button>
  );
}
