// Keyboard control of the shown time, for keys that no control of the page uses.

export interface TimeKeys {
  toggle: () => void;
  step: (seconds: number) => void;
  first: () => void;
  last: () => void;
}

const OTHERS = "input, select, textarea, button, summary, a, canvas, [tabindex], [role=tab], [contenteditable]";

export function listen(keys: TimeKeys): () => void {
  const press = (event: KeyboardEvent): void => {
    const isUsed = event.target instanceof Element && event.target.closest(OTHERS) !== null;
    if (isUsed || event.defaultPrevented || event.altKey || event.ctrlKey || event.metaKey || !take(event, keys)) {
      return;
    }
    event.preventDefault();
  };
  window.addEventListener("keydown", press);
  return () => window.removeEventListener("keydown", press);
}

/** Executes the action of a key; returns false for other keys. */
export function take({ key, shiftKey }: { key: string; shiftKey: boolean }, keys: TimeKeys): boolean {
  const step = shiftKey ? 0.1 : 0.004;
  switch (key) {
    case " ": keys.toggle(); return true;
    case "ArrowLeft": keys.step(-step); return true;
    case "ArrowRight": keys.step(step); return true;
    case "Home": keys.first(); return true;
    case "End": keys.last(); return true;
    default: return false;
  }
}
