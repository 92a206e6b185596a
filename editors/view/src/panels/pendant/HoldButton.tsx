// Button that moves the arm while it is held.

import type { ComponentChildren, JSX, TargetedMouseEvent, TargetedPointerEvent } from "preact";
import type { Notice } from "../shared/cell";
import type { Holder, Step } from "./Holder";

interface Props {
  label: string;
  children: ComponentChildren;
  holder: Holder;
  notice: Notice;
  reason: string | undefined;
  step: Step;
}

/** Moves while the pointer holds the button; the keyboard executes single steps. */
export function HoldButton({ label, children, holder, notice, reason, step }: Props): JSX.Element {
  const down = (event: TargetedPointerEvent<HTMLSpanElement>): void => {
    if (reason === undefined && event.button === 0) {
      holder.hold(step);
    }
  };
  const release = (): void => holder.release();
  return (
    <span class="hold" onPointerDown={down} onPointerUp={release} onPointerLeave={release} onPointerCancel={release}>
      <KeyButton label={label} reason={reason} notice={notice} onKey={() => holder.once(step)}>{children}</KeyButton>
    </span>
  );
}

function KeyButton({ label, reason, notice, onKey, children }: { label: string; reason: string | undefined; notice: Notice; onKey: () => void; children: ComponentChildren }): JSX.Element {
  const press = (event: TargetedMouseEvent<HTMLButtonElement>): void => {
    if (reason !== undefined) {
      notice.text.value = reason;
    } else if (event.detail === 0) {
      onKey();
    }
  };
  return (
    <button type="button" aria-label={label} title={reason ?? label} aria-disabled={reason === undefined ? undefined : true} onClick={press}>{children}</button>
  );
}
