// Sentence about the last rejection, and the line of a panel for sentences.

import type { JSX } from "preact";
import type { Cell, Notice } from "./cell";

export function NoticeLine({ notice }: { notice: Notice }): JSX.Element {
  const text = notice.text.value;
  return (
    <p class="notice" role="status">
      {text}
      {text === "" ? null : <button type="button" class="quiet" aria-label="Hide this message" onClick={() => (notice.text.value = "")}>×</button>}
    </p>
  );
}

interface MessageProps {
  cell: Pick<Cell, "blocked">;
  notice: Notice;
  /** State of the robot that the operator must know; empty for none. */
  state?: string;
}

/** Line for the last rejection, the state, or the reason why nothing can be operated. Without them its space stays empty, so that no button moves. */
export function MessageLine({ cell, notice, state = "" }: MessageProps): JSX.Element {
  const blocked = cell.blocked.value;
  const isQuiet = notice.text.value === "";
  return (
    <div class="messages">
      <NoticeLine notice={notice} />
      {isQuiet && state !== "" ? <p class="state-line" role="status">{state}</p> : null}
      {isQuiet && state === "" && blocked !== undefined ? <p class="blocked">{blocked}</p> : null}
    </div>
  );
}
