// Program lines that the user opens: in the editor, otherwise on the tab Program.

import type { NamedLine } from "../program/programs";
import type { Cell } from "./cell";

export interface Opening {
  title: string;
  open: () => void;
}

/** Returns how a line is opened; `undefined` if neither the editor nor the page has it. */
export function openingOf(cell: Cell, line: NamedLine): Opening | undefined {
  const { program, file } = line;
  const openLine = cell.openLine.value;
  if (line.line <= 0) {
    return undefined;
  }
  if (openLine !== undefined) {
    return file === undefined || file === "" ? undefined : { title: `Open ${file}`, open: () => openLine({ program, line: line.line, file }) };
  }
  const found = cell.code.programOf(line);
  return found && { title: `Show the line of ${found.application}`, open: () => cell.showLine(line) };
}
