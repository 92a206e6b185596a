// Theme of the editor, whose colours a canvas does not follow by itself.

import { signal } from "@preact/signals";

/** Number of theme changes. */
export const themes = signal(0);

export function followTheme(): void {
  const changed = (): void => { themes.value += 1; };
  // VS Code writes the theme to the classes of the body and the colours to the style of the root.
  const observer = new MutationObserver(changed);
  observer.observe(document.body, { attributeFilter: ["class"] });
  observer.observe(document.documentElement, { attributeFilter: ["style"] });
  matchMedia("(prefers-color-scheme: dark)").addEventListener("change", changed);
}
