// Part of a panel that the user can fold. The choice survives a reload.

import type { ComponentChildren, JSX, TargetedMouseEvent } from "preact";
import { useState } from "preact/hooks";
import { remember, remembered } from "../memory";

interface FoldProps {
  /** Name under which the choice is stored. */
  name: string;
  label: string;
  className?: string;
  /** Whether the part is open until the user chooses. */
  isOpenAtFirst: boolean;
  children: ComponentChildren;
}

export function Fold({ name, label, className = "", isOpenAtFirst, children }: FoldProps): JSX.Element {
  const key = `fold.${name}`;
  const [chosen, choose] = useState(() => remembered(key));
  const isOpen = chosen === undefined ? isOpenAtFirst : chosen === "open";
  const toggle = (event: TargetedMouseEvent<HTMLElement>): void => {
    // The element must not open on its own, because the state decides.
    event.preventDefault();
    const next = isOpen ? "folded" : "open";
    choose(next);
    remember(key, next);
  };
  return (
    <details class={`fold ${className}`} open={isOpen}>
      <summary onClick={toggle}>{label}</summary>
      {isOpen ? children : null}
    </details>
  );
}
