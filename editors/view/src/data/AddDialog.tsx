// New data: name, type, access, container and size.

import type { JSX } from "preact";
import { useState } from "preact/hooks";
import { sizeFrom } from "./cells";
import { ModalForm } from "./ModalForm";
import { ALL, type DataModel } from "./model";
import type { Access, Container, DataEdit } from "./protocol";
import { useChecked } from "./useChecked";

export function AddDialog({ model }: { model: DataModel }): JSX.Element {
  const types = (model.tables.value?.types ?? []).filter(({ containers }) => containers.length > 0);
  const active = model.activeRow();
  const shown = model.shown.value === ALL ? active?.datum.type : model.shown.value;
  const [name, setName] = useState("");
  const [type, setType] = useState(types.find((type) => type.name === shown)?.name ?? types[0]?.name ?? "");
  const [access, setAccess] = useState<Access>("private");
  const containers = model.types.value.get(type)?.containers ?? ["array"];
  const [wanted, setContainer] = useState<Container>("array");
  const container = containers.includes(wanted) ? wanted : (containers[0] ?? "array");
  const [size, setSize] = useState("1");
  const edit = addEdit({ name, type, access, container, size }, active?.container.name);
  const verdict = useChecked(model, name === "" ? undefined : edit);
  const add = async (): Promise<boolean> => {
    const isDone = typeof edit !== "string" && (await model.edit([edit]));
    if (isDone) {
      model.reveal(name);
    }
    return isDone;
  };
  return (
    <ModalForm model={model} title="Add data" confirm="Add" reason={name === "" ? "The data needs a name." : typeof edit === "string" ? edit : undefined} onConfirm={add}>
      <label>Name <input value={name} spellcheck={false} aria-invalid={verdict.message !== ""} aria-describedby="add-verdict" onInput={({ currentTarget }) => setName(currentTarget.value)} /></label>
      <label>Type <select value={type} onChange={({ currentTarget }) => setType(currentTarget.value)}>{types.map(({ name }) => <option key={name} value={name}>{name}</option>)}</select></label>
      <label>Access <select value={access} onChange={({ currentTarget }) => setAccess(currentTarget.value as Access)}><option value="private">private</option><option value="public">public</option></select></label>
      <label>Container <select value={container} onChange={({ currentTarget }) => setContainer(currentTarget.value as Container)}>{containers.map((container) => <option key={container} value={container}>{container}</option>)}</select></label>
      {container === "array" ? <label>Size <input value={size} onInput={({ currentTarget }) => setSize(currentTarget.value)} /></label> : null}
      <p id="add-verdict" class="verdict" role="status">{verdict.message}</p>
    </ModalForm>
  );
}

interface NewDatum {
  name: string;
  type: string;
  access: Access;
  container: Container;
  size: string;
}

/** Returns the edit, or a sentence if the size is invalid. */
function addEdit({ size, ...datum }: NewDatum, after: string | undefined): DataEdit | string {
  const numbers = datum.container === "array" ? sizeFrom(size) : [];
  return numbers === undefined ? `A size is up to three whole numbers, such as "10" or "3 4", not "${size}".` : { kind: "add", ...datum, size: numbers, ...(after !== undefined && { after }) };
}
