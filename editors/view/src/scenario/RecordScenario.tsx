// Button and dialog that write a scenario of the run for `val3 test`.

import type { JSX, TargetedSubmitEvent } from "preact";
import { useLayoutEffect, useRef, useState } from "preact/hooks";
import { Notice } from "../panels/shared/cell";
import { NoticeLine } from "../panels/shared/NoticeLine";
import type { Store } from "../store";
import { nameFault, type Scenario, scenarioFrom } from "./scenario";
import "./scenario.css";

/** Shown to operators of a run that the page's own server executes. */
export function RecordScenario({ store }: { store: Store }): JSX.Element | null {
  const [isOpen, setOpen] = useState(false);
  if (store.scene.value?.role !== "operator") {
    return null;
  }
  return (
    <>
      <button type="button" onClick={() => setOpen(true)}>Record scenario…</button>
      {isOpen ? <ScenarioDialog store={store} onClose={() => setOpen(false)} /> : null}
    </>
  );
}

function ScenarioDialog({ store, onClose }: { store: Store; onClose: () => void }): JSX.Element {
  const dialog = useRef<HTMLDialogElement>(null);
  const [notice] = useState(() => new Notice());
  const [isBusy, setBusy] = useState(false);
  const [written, setWritten] = useState<Scenario>();
  // Synchronous, so that the next key reaches the dialog.
  useLayoutEffect(() => {
    const element = dialog.current;
    element?.showModal();
    return () => element?.close();
  }, []);
  const record = async (name: string): Promise<void> => {
    setBusy(true);
    notice.text.value = "";
    const answer = await store.command("record", { name });
    setBusy(false);
    notice.text.value = answer.error ?? "";
    setWritten(answer.error === null ? scenarioFrom(answer) : undefined);
  };
  return (
    <dialog ref={dialog} class="scenario" aria-label="Record scenario" onClose={onClose} onKeyDown={(event) => event.key !== "Escape" && event.stopPropagation()}>
      <h2>Record scenario</h2>
      {written === undefined ? <NameForm isBusy={isBusy} notice={notice} onName={(name) => void record(name)} onCancel={onClose} /> : <WrittenScenario scenario={written} onClose={onClose} />}
    </dialog>
  );
}

interface NameFormProps {
  isBusy: boolean;
  notice: Notice;
  onName: (name: string) => void;
  onCancel: () => void;
}

function NameForm({ isBusy, notice, onName, onCancel }: NameFormProps): JSX.Element {
  const [name, setName] = useState("");
  const submit = (event: TargetedSubmitEvent<HTMLFormElement>): void => {
    event.preventDefault();
    const fault = isBusy ? undefined : nameFault(name);
    if (fault !== undefined) {
      notice.text.value = fault;
    } else if (!isBusy) {
      onName(name);
    }
  };
  return (
    <form onSubmit={submit}>
      <p>Writes a test of the run from its start up to now. Operations, inputs and received bytes become events. Outputs, printed lines and errors become expectations.</p>
      <label>Name <input value={name} onInput={({ currentTarget }) => setName(currentTarget.value)} autocomplete="off" spellcheck={false} /></label>
      <NoticeLine notice={notice} />
      <div class="row">
        <button type="submit" class="primary" aria-disabled={isBusy}>{isBusy ? "Executing the scenario…" : "Record"}</button>
        <button type="button" onClick={onCancel}>Cancel</button>
      </div>
    </form>
  );
}

function WrittenScenario({ scenario, onClose }: { scenario: Scenario; onClose: () => void }): JSX.Element {
  const close = useRef<HTMLButtonElement>(null);
  useLayoutEffect(() => close.current?.focus(), []);
  return (
    <>
      <p role="status">Wrote {scenario.file}. The application has passed it once. Execute it with <code>val3 test {scenario.file}</code>.</p>
      {scenario.remarks.length === 0 ? null : <><p>The scenario has a comment about each of these differences:</p><ul aria-label="Differences from the run">{scenario.remarks.map((remark) => <li key={remark}>{remark}.</li>)}</ul></>}
      <pre tabIndex={0} aria-label="Text of the scenario">{scenario.text}</pre>
      <div class="row"><button type="button" ref={close} onClick={onClose}>Close</button></div>
    </>
  );
}
