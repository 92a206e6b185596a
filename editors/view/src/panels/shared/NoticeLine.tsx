// Sentence about the last rejection.

import type { JSX } from "preact";
import type { Notice } from "./cell";

export function NoticeLine({ notice }: { notice: Notice }): JSX.Element {
  const text = notice.text.value;
  return (
    <p class="notice" role="status">
      {text}
      {text === "" ? null : <button type="button" class="quiet" aria-label="Hide this message" onClick={() => (notice.text.value = "")}>×</button>}
    </p>
  );
}
