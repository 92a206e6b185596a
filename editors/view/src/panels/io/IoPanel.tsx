// Inputs and outputs of the cell by board, and its sockets and serial lines.

import type { JSX } from "preact";
import { useMemo, useState } from "preact/hooks";
import { type Cell, Notice } from "../shared/cell";
import { LongTable } from "../shared/LongTable";
import { MessageLine } from "../shared/NoticeLine";
import { LinesTable } from "./LinesTable";
import { SignalCells } from "./SignalCells";
import { longestName, rowsOf, type SignalFilter, type SignalRow, sorted } from "./signalRows";

const COLUMNS = ["Signal", "Value", "Operator", "Fault", "Last 10 s"];
const ALL: SignalFilter = { text: "", direction: "all", isMarkedOnly: false };

export function IoPanel({ cell }: { cell: Cell }): JSX.Element {
  const notice = useMemo(() => new Notice(), []);
  const [filter, setFilter] = useState(ALL);
  const scene = cell.scene.value;
  const signals = useMemo(() => sorted(scene?.signals ?? []), [scene]);
  const longest = useMemo(() => longestName(signals), [signals]);
  // Values affect the rows only with this filter.
  const marked = filter.isMarkedOnly ? cell.levels.value : undefined;
  const rows = useMemo(() => rowsOf(signals, filter, (link) => cell.levels.peek().get(link)), [signals, filter, marked, cell]);
  const count = rows.filter((row) => "signal" in row).length;
  return (
    <section class="panel io" aria-label="Inputs and outputs" style={{ "--names": longest }}>
      <MessageLine cell={cell} notice={notice} />
      <div class="row tools">
        <input type="search" aria-label="Filter signals by link or data" placeholder="Filter: link or data" value={filter.text} onInput={({ currentTarget }) => setFilter({ ...filter, text: currentTarget.value })} />
        <select aria-label="Direction" value={filter.direction} onChange={({ currentTarget }) => setFilter({ ...filter, direction: currentTarget.value as SignalFilter["direction"] })}>
          <option value="all">Inputs and outputs</option>
          <option value="input">Inputs</option>
          <option value="output">Outputs</option>
        </select>
        <label><input type="checkbox" checked={filter.isMarkedOnly} onChange={({ currentTarget }) => setFilter({ ...filter, isMarkedOnly: currentTarget.checked })} /> Locked, simulated, protected or faulty</label>
        <span class="count" role="status">{count} of {signals.length}</span>
      </div>
      <LongTable<SignalRow>
        label="Signals" className="signals" columns={COLUMNS} rows={rows} empty={signals.length === 0 ? "The cell has no inputs or outputs." : "No signal matches the filter."}
        keyOf={(row) => ("board" in row ? `board ${row.board}` : row.signal.link)}
        rowClass={(row) => ("board" in row ? "board" : undefined)}
        cells={(row) => ("board" in row
          ? <th scope="rowgroup" colSpan={COLUMNS.length}><span class="board-name">{row.board} <span class="count">{row.count}</span></span></th>
          : <SignalCells cell={cell} notice={notice} signal={row.signal} />)}
      />
      <LinesTable cell={cell} />
    </section>
  );
}
