// Program line, which opens in the editor, or on the tab Program.

import type { JSX } from "preact";
import type { NamedLine } from "../program/programs";
import type { Cell } from "./cell";
import { openingOf } from "./opening";

export function Place({ cell, program, line, file }: NamedLine & { cell: Cell }): JSX.Element {
  const text = line > 0 ? `${program}:${line}` : program;
  const opening = openingOf(cell, { program, line, file });
  return opening === undefined
    ? <span class="place" title={file}>{text}</span>
    : <button type="button" class="place" title={opening.title} onClick={opening.open}>{text}</button>;
}
