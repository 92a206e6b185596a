// Button over the picture that opens a list, which a press outside it closes.

import type { ComponentChildren, JSX } from "preact";
import { useEffect, useRef } from "preact/hooks";

export function Menu({ label, className = "", children }: { label: string; className?: string; children: ComponentChildren }): JSX.Element {
  const menu = useRef<HTMLDetailsElement>(null);
  useEffect(() => {
    const close = ({ target }: Event): void => {
      if (menu.current !== null && !(target instanceof Node && menu.current.contains(target))) {
        menu.current.open = false;
      }
    };
    document.addEventListener("pointerdown", close);
    return () => document.removeEventListener("pointerdown", close);
  }, []);
  return (
    <details class={`menu ${className}`} ref={menu}>
      <summary>{label}</summary>
      <div role="group" aria-label={label}>{children}</div>
    </details>
  );
}
