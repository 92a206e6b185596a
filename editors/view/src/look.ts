// Light and dark look: from the system until the user chooses one.

import { signal } from "@preact/signals";
import { remember, remembered } from "./memory";

const KEY = "look";

export const isDark = signal(false);

export function followLook(): void {
  const system = matchMedia("(prefers-color-scheme: dark)");
  // VS Code writes its look to the body element.
  const editor = document.body.dataset["vscodeThemeKind"];
  const chosen = remembered(KEY);
  show(chosen !== undefined ? chosen === "dark" : editor === undefined ? system.matches : /dark|high-contrast$/.test(editor));
  system.addEventListener("change", ({ matches }) => show(matches));
}

export function toggleLook(): void {
  show(!isDark.peek());
  remember(KEY, isDark.peek() ? "dark" : "light");
}

function show(dark: boolean): void {
  isDark.value = dark;
  document.documentElement.dataset["theme"] = dark ? "dark" : "light";
}
