// Modal dialog of the page. Escape closes it.

import type { ComponentChildren, JSX, TargetedSubmitEvent } from "preact";
import { useLayoutEffect, useRef } from "preact/hooks";
import { NoticeLine } from "../panels/shared/NoticeLine";
import type { DataModel } from "./model";

interface Props {
  model: DataModel;
  title: string;
  /** Text of the button that confirms. */
  confirm: string;
  /** Reason why the form cannot be confirmed. */
  reason?: string | undefined;
  children: ComponentChildren;
  /** Returns whether the form is complete. */
  onConfirm: () => Promise<boolean>;
}

export function ModalForm({ model, title, confirm, reason, children, onConfirm }: Props): JSX.Element {
  const dialog = useRef<HTMLDialogElement>(null);
  // Synchronous, so that the next key reaches the dialog.
  useLayoutEffect(() => {
    model.notice.text.value = "";
    const element = dialog.current;
    element?.showModal();
    return () => {
      element?.close();
      document.querySelector<HTMLElement>("[role=treegrid]")?.focus({ preventScroll: true });
    };
  }, []);
  const close = (): void => void (model.dialog.value = undefined);
  const submit = (event: TargetedSubmitEvent<HTMLFormElement>): void => {
    event.preventDefault();
    if (reason === undefined) {
      void onConfirm().then((isDone) => isDone && close());
    } else {
      model.notice.text.value = reason;
    }
  };
  return (
    <dialog ref={dialog} class="modal" aria-label={title} onClose={close} onKeyDown={(event) => event.key !== "Escape" && event.stopPropagation()}>
      <form onSubmit={submit}>
        <h2>{title}</h2>
        {children}
        <NoticeLine notice={model.notice} />
        <div class="row buttons">
          <button type="submit" class="primary" aria-disabled={reason === undefined ? undefined : true} title={reason}>{confirm}</button>
          <button type="button" onClick={close}>Cancel</button>
        </div>
      </form>
    </dialog>
  );
}
