// Button that shows why it is disabled.

import type { ComponentChildren, JSX } from "preact";

export interface ButtonProps {
  children: ComponentChildren;
  /** For screen readers, if the content is a symbol. */
  label?: string | undefined;
  title?: string | undefined;
  className?: string | undefined;
  isPressed?: boolean | undefined;
  /** Reason why the button is disabled. It keeps the focus, so that the reason can be read. */
  reason?: string | undefined;
  onPress: () => void;
  onRefused?: ((reason: string) => void) | undefined;
}

export function Button({ children, label, title, className, isPressed, reason, onPress, onRefused }: ButtonProps): JSX.Element {
  const press = (): void => {
    if (reason === undefined) {
      onPress();
    } else {
      onRefused?.(reason);
    }
  };
  return (
    <button
      type="button"
      class={className}
      aria-label={label}
      aria-pressed={isPressed}
      aria-disabled={reason === undefined ? undefined : true}
      title={reason ?? title ?? label}
      onClick={press}
    >
      {children}
    </button>
  );
}
