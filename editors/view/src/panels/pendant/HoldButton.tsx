// Button that moves the arm while it is held.

import type { ComponentChildren, JSX, TargetedMouseEvent, TargetedPointerEvent } from "preact";
import { useEffect, useRef, useState } from "preact/hooks";
import type { Notice } from "../shared/cell";
import type { Holder, Step } from "./Holder";
import { type Area, isWithin } from "./pressedArea";

interface Props {
  label: string;
  children: ComponentChildren;
  holder: Holder;
  notice: Notice;
  reason: string | undefined;
  step: Step;
}

/**
 * Moves while the pointer holds the button; the keyboard executes single steps. The button is released when the pointer
 * leaves the area of the pressed button. It stays held if the page moves the button away from a resting pointer, for
 * example because a fault is shown above it.
 */
export function HoldButton({ label, children, holder, notice, reason, step }: Props): JSX.Element {
  const area = useRef<Area | undefined>(undefined);
  const [isHeld, setHeld] = useState(false);
  const release = (): void => {
    if (area.current !== undefined) {
      area.current = undefined;
      setHeld(false);
      holder.release();
    }
  };
  const press = (event: TargetedPointerEvent<HTMLSpanElement>): void => {
    const { currentTarget, pointerId, button } = event;
    if (reason === undefined && button === 0) {
      area.current = currentTarget.getBoundingClientRect();
      currentTarget.querySelector("button")?.setPointerCapture(pointerId);
      setHeld(true);
      holder.hold(step);
    }
  };
  const move = ({ clientX, clientY }: TargetedPointerEvent<HTMLSpanElement>): void => {
    if (area.current !== undefined && !isWithin(area.current, clientX, clientY)) {
      release();
    }
  };
  useEffect(() => release, [holder]);
  useEffect(() => {
    if (reason !== undefined) {
      release();
    }
  }, [reason]);
  useEffect(() => {
    // Another window may receive the end of the press.
    window.addEventListener("blur", release);
    return () => window.removeEventListener("blur", release);
  }, [holder]);
  return (
    <span class={isHeld ? "hold held" : "hold"} onPointerDown={press} onPointerMove={move} onPointerUp={release} onPointerCancel={release} onLostPointerCapture={release}>
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
