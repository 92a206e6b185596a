// Text with code between backticks.

import type { JSX } from "preact";

export function CodeText({ text }: { text: string }): JSX.Element {
  // Every second part is code.
  return <>{text.split("`").map((part, number) => (number % 2 === 1 ? <code key={number}>{part}</code> : part))}</>;
}
