// Program line, which opens in the editor if there is one.

import type { JSX } from "preact";
import type { Cell } from "./cell";

export function Place({ cell, program, line, file }: { cell: Cell; program: string; line: number; file?: string | undefined }): JSX.Element {
  const text = line > 0 ? `${program}:${line}` : program;
  const openLine = cell.openLine.value;
  return openLine === undefined || file === undefined || file === "" || line <= 0
    ? <span class="place" title={file}>{text}</span>
    : <button type="button" class="place" title={`Open ${file}`} onClick={() => openLine({ program, line, file })}>{text}</button>;
}
