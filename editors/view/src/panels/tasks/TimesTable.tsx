// Table of times by program line, for the arm and the tasks.

import type { JSX } from "preact";
import { useMemo, useState } from "preact/hooks";
import type { Cell } from "../shared/cell";
import { Place } from "../shared/Place";
import { CycleTable } from "./CycleTable";
import { ArmTimes, share, taskTimes, type TimeRow } from "./times";

export function TimesTable({ cell }: { cell: Cell }): JSX.Element {
  // Counting the times of a long run is slow, so they are counted once per second.
  const end = Math.floor(cell.slowTime.value);
  const [isExact, setExact] = useState(false);
  const until = isExact ? cell.slowTime.value : end;
  // The older part of a long run is discarded.
  const [start] = cell.whole.value;
  const counter = useMemo(() => new ArmTimes(cell.history.samples), [cell]);
  const arm = useMemo(() => counter.between(start, until), [counter, start, until]);
  const tasks = useMemo(() => taskTimes(cell.history.states, until), [cell, start, until]);
  return (
    <div class="scroll" tabIndex={0} role="region" aria-label="Times by program line">
      <p class="reason">
        Times {start > 0 ? `from ${start.toFixed(0)} s ` : ""}up to {until.toFixed(isExact ? 3 : 0)} s. Those of the arm are exact to a cycle of 4 ms, those of tasks to 0.1 s; val3 run --times has all to a cycle.{" "}
        <label><input type="checkbox" checked={isExact} onChange={({ currentTarget }) => setExact(currentTarget.checked)} /> Up to the shown time</label>
      </p>
      <CycleTable cell={cell} until={until} />
      <TimesOf cell={cell} caption="Arm" rows={arm} total={until - start} hasTask={false} />
      <TimesOf cell={cell} caption="Tasks" rows={tasks} total={until - start} hasTask />
    </div>
  );
}

function TimesOf({ cell, caption, rows, total, hasTask }: { cell: Cell; caption: string; rows: readonly TimeRow[]; total: number; hasTask: boolean }): JSX.Element {
  return (
    <table>
      <caption>{caption}</caption>
      <thead>
        <tr><th scope="col" class="figure">Seconds</th><th scope="col" class="figure">Share</th>{hasTask ? <th scope="col">Task</th> : null}<th scope="col">Line</th><th scope="col">Activity</th></tr>
      </thead>
      <tbody>
        {rows.map(({ task, program, line, activity, seconds }) => (
          <tr key={`${task} ${program} ${line} ${activity}`}>
            <td class="figure">{seconds.toFixed(3)}</td><td class="figure">{share(seconds, total)}</td>{hasTask ? <td>{task}</td> : null}
            <td>{line > 0 ? <Place cell={cell} program={program} line={line} /> : "–"}</td><td>{activity}</td>
          </tr>
        ))}
      </tbody>
    </table>
  );
}
