// Tasks at the shown time.

import type { JSX } from "preact";
import type { Cell } from "../shared/cell";
import { CodeText } from "../shared/CodeText";
import { Place } from "../shared/Place";
import type { TaskState } from "./chart";

export function TaskTable({ cell }: { cell: Cell }): JSX.Element {
  const tasks = cell.state.value?.tasks ?? [];
  return (
    <table class="task-table">
      <caption>Tasks</caption>
      <thead>
        <tr><th scope="col">Task</th><th scope="col">State</th><th scope="col">Line</th><th scope="col">Schedule</th><th scope="col">Overruns</th></tr>
      </thead>
      <tbody>
        {tasks.map((task) => (
          <tr key={task.name}>
            <th scope="row">{task.name}</th>
            <td class={`task-state ${task.state}`}><span class={`swatch ${task.state}`} aria-hidden="true" /><CodeText text={stateText(task)} /></td>
            <td><Place cell={cell} program={task.program} line={task.line} file={task.file} /></td>
            <td>{pace(task)}</td>
            <td>{task.period === null ? "–" : task.overruns}</td>
          </tr>
        ))}
        {tasks.length === 0 ? <tr><td colSpan={5}>No task exists.</td></tr> : null}
      </tbody>
    </table>
  );
}

function stateText({ state, waits, error }: TaskState): string {
  return error !== null ? `error ${error}` : waits !== null ? `waits for ${waits}` : state;
}

function pace({ priority, period }: TaskState): string {
  return period !== null ? `every ${Number((period * 1000).toFixed(3))} ms` : priority !== null ? `priority ${priority}` : "–";
}
