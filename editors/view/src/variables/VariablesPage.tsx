// Page with the parameters and locals of a program.

import type { JSX } from "preact";
import { useLayoutEffect } from "preact/hooks";
import { keptLocals, keptParameters, moved, removed, replaced } from "./edits";
import { kindOf, kinds, shapeOf } from "./kinds";
import type { Edits, LocalEdit, ParameterEdit, Variables } from "./messages";
import type { Focus, List, Row, VariablesModel } from "./model";
import type { Draft } from "./NewVariable";
import { readSize, shownSize } from "./sizes";
import { type RowActions, VariableRow } from "./VariableRow";
import { VariableTable } from "./VariableTable";

const NO_SIZE = "the size is one to three numbers, such as `3` or `3 x 4`";

export function VariablesPage({ model }: { model: VariablesModel }): JSX.Element {
  const variables = model.variables.value;
  useLayoutEffect(() => restoreFocus(model), [model.revision.value]);
  if (variables === null) {
    return <p class="empty" role="status">{model.hasProgram.value
      ? "The parameters and local variables of this file cannot be read."
      : "Open a program to see its parameters and local variables."}</p>;
  }
  return (
    <main aria-label={`Variables of ${variables.program}`} key={variables.uri}>
      <Parameters model={model} variables={variables} />
      <Locals model={model} variables={variables} />
    </main>
  );
}

const NO_NAME = "a new variable needs a name";

/** Keeps the focus in the field that has moved with its row. */
function restoreFocus(model: VariablesModel): void {
  const { focus } = model;
  model.focus = undefined;
  if (focus !== undefined) {
    const row = document.querySelector(`tr[data-list="${focus.list}"][data-index="${focus.index}"]`);
    row?.querySelector<HTMLElement>(`[data-field="${focus.field}"]`)?.focus();
  }
}

function refuse(model: VariablesModel, row: Row, reason: string): Promise<boolean> {
  model.refuse(row, reason);
  return Promise.resolve(false);
}

/** Returns the field that has the focus now, in another row. */
function focusIn(row: Row): Focus {
  const field = document.activeElement?.getAttribute("data-field") ?? "name";
  return { ...row, field };
}

/** Returns move and remove, which parameters and locals have in common. */
function actionsOf<Entry>(model: VariablesModel, row: Row, list: Entry[], edits: (list: Entry[]) => Edits): Pick<RowActions, "move" | "remove"> {
  const move = (by: number): void => {
    const index = row.index + by;
    const now = moved(list, row.index, index);
    if (now !== undefined) {
      void model.edit(row, edits(now), focusIn({ ...row, index }));
    }
  };
  const remove = (): void => {
    const index = Math.max(0, Math.min(row.index, list.length - 2));
    void model.edit(row, edits(removed(list, row.index)), { ...row, index, field: "name" });
  };
  return { move, remove };
}

interface ListProps {
  model: VariablesModel;
  variables: Variables;
}

function Parameters({ model, variables: { parameters, types, isOld, fixed } }: ListProps): JSX.Element {
  const list: List = "parameters";
  const kept = keptParameters(parameters);
  const edits = (parameters: ParameterEdit[]): Edits => ({ parameters });
  const add = ({ name, type, shape, argument }: Draft): Promise<boolean> => {
    if (name.trim() === "") {
      return refuse(model, { list, index: kept.length }, NO_NAME);
    }
    const added = { name: name.trim(), type, argument, ...shapeOf(shape) };
    return model.edit({ list, index: kept.length }, edits([...kept, added]));
  };
  const rows = parameters.map((parameter, index) => {
    const row = { list, index };
    const change = (change: Partial<ParameterEdit>): Promise<boolean> => model.edit(row, edits(replaced(kept, index, change)));
    const actions: RowActions = {
      ...actionsOf(model, row, kept, edits),
      rename: (name) => change({ name: name.trim() }),
      retype: (type) => change({ type }),
      reshape: (kind) => change(shapeOf(kind)),
    };
    return (
      <VariableRow
        key={index} model={model} list={list} index={index} count={parameters.length} name={parameter.name} type={parameter.type} types={types}
        shape={kindOf(parameter, isOld)} shapes={kinds(isOld)} uses={parameter.uses} actions={actions}
      />
    );
  });
  return (
    <VariableTable model={model} list={list} types={types} shapes={kinds(isOld)} count={parameters.length} fixed={fixed} onAdd={add}>
      {rows}
    </VariableTable>
  );
}

function Locals({ model, variables: { locals, types } }: ListProps): JSX.Element {
  const list: List = "locals";
  const kept = keptLocals(locals);
  const edits = (locals: LocalEdit[]): Edits => ({ locals });
  const sized = (row: Row, text: string, edit: (size: number[]) => Promise<boolean>): Promise<boolean> => {
    const size = readSize(text);
    return size === undefined ? refuse(model, row, NO_SIZE) : edit(size);
  };
  const add = ({ name, type, shape }: Draft): Promise<boolean> => {
    const row = { list, index: kept.length };
    if (name.trim() === "") {
      return refuse(model, row, NO_NAME);
    }
    return sized(row, shape, (size) => model.edit(row, edits([...kept, { name: name.trim(), type, size }])));
  };
  const rows = locals.map((local, index) => {
    const row = { list, index };
    const change = (change: Partial<LocalEdit>): Promise<boolean> => model.edit(row, edits(replaced(kept, index, change)));
    const actions: RowActions = {
      ...actionsOf(model, row, kept, edits),
      rename: (name) => change({ name: name.trim() }),
      retype: (type) => change({ type }),
      reshape: (text) => sized(row, text, (size) => change({ size })),
    };
    return (
      <VariableRow
        key={index} model={model} list={list} index={index} count={locals.length} name={local.name} type={local.type} types={types}
        shape={shownSize(local.size)} shapes={undefined} uses={local.uses} actions={actions}
      />
    );
  });
  return (
    <VariableTable model={model} list={list} types={types} shapes={undefined} count={locals.length} fixed={null} onAdd={add}>
      {rows}
    </VariableTable>
  );
}
