// Table of the parameters or of the locals.

import type { ComponentChildren, JSX } from "preact";
import { useRef, useState } from "preact/hooks";
import type { List, VariablesModel } from "./model";
import { type Draft, NewVariable } from "./NewVariable";
import { Reason, sentence } from "./VariableRow";

interface TableProps {
  model: VariablesModel;
  list: List;
  types: readonly string[];
  shapes: readonly string[] | undefined;
  /** Number of rows; a row for a new variable follows. */
  count: number;
  /** Reason why nothing can be added. */
  fixed: string | null;
  children: ComponentChildren;
  /** Adds a variable, and returns whether it was added. */
  onAdd: (draft: Draft) => Promise<boolean>;
}

const TITLE: Record<List, string> = { parameters: "Parameters", locals: "Locals" };

export function VariableTable({ model, list, types, shapes, count, fixed, children, onAdd }: TableProps): JSX.Element {
  const [isAdding, setAdding] = useState(false);
  const button = useRef<HTMLButtonElement>(null);
  const title = TITLE[list];
  const add = list === "parameters" ? "Add parameter" : "Add local";
  const refusal = model.refusal.value;
  const isRefused = isAdding && refusal?.list === list && refusal.index === count;
  const close = (): void => {
    setAdding(false);
    model.forgive();
    button.current?.focus();
  };
  const commit = async (draft: Draft): Promise<void> => {
    if (await onAdd(draft)) {
      close();
    }
  };
  const open = (): void => {
    if (fixed === null) {
      setAdding(true);
    }
  };
  return (
    <section class={list}>
      <header>
        <h2 id={`${list}-title`}>{title} <span class="count">{count}</span></h2>
        <button type="button" ref={button} aria-disabled={fixed === null ? undefined : true} title={fixed ?? add} onClick={open}>{add}</button>
      </header>
      {fixed !== null && <p class="fixed">{sentence(fixed)}</p>}
      {count > 0 || isAdding ? (
        <table role="table" aria-labelledby={`${list}-title`}>
          <thead role="rowgroup">
            <tr role="row">
              <th role="columnheader" scope="col" class="name">Name</th>
              <th role="columnheader" scope="col" class="type">Type</th>
              <th role="columnheader" scope="col" class="shape">{list === "parameters" ? "Passing" : "Size"}</th>
              <th role="columnheader" scope="col" class="uses">Uses</th>
              <th role="columnheader" scope="col" class="buttons"><span class="hidden">Actions</span></th>
            </tr>
          </thead>
          <tbody role="rowgroup">
            {children}
            {isAdding && (
              <NewVariable
                list={list} types={types} shapes={shapes} fault={isRefused ? `${list}-new-reason` : undefined}
                onAdd={(draft) => void commit(draft)} onCancel={close}
              />
            )}
            {isRefused && <Reason id={`${list}-new-reason`} reason={refusal.reason} />}
          </tbody>
        </table>
      ) : <p class="empty">{list === "parameters" ? "The program has no parameters." : "The program has no local variables."}</p>}
    </section>
  );
}
