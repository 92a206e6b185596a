// The light and the dark look: that of the system until the reader chooses.

import { signal } from "@preact/signals";

export const isDark = signal(false);

export function followLook(): void {
  const system = matchMedia("(prefers-color-scheme: dark)");
  // VS Code names its look on the body.
  const editor = document.body.dataset["vscodeThemeKind"];
  show(editor === undefined ? system.matches : /dark|high-contrast$/.test(editor));
  system.addEventListener("change", ({ matches }) => show(matches));
}

export function toggleLook(): void {
  show(!isDark.peek());
}

function show(dark: boolean): void {
  isDark.value = dark;
  document.documentElement.dataset["theme"] = dark ? "dark" : "light";
}
