// Program with the lines that tasks execute, and the line of the present move.

import type { JSX } from "preact";
import { useMemo, useRef } from "preact/hooks";
import type { Cell } from "../shared/cell";
import { Place } from "../shared/Place";
import type { TaskState } from "../tasks/chart";
import { CodeTable } from "./CodeTable";
import { marksOf } from "./marks";
import { type CodeLine, groupsOf, keyOf, type Program } from "./programs";
import { followedLine, followedTask } from "./ProgramView";
import "./program.css";

export function ProgramPanel({ cell }: { cell: Cell }): JSX.Element {
  const { code } = cell;
  const chosen = code.chosen.value;
  const tasks = cell.state.value?.tasks ?? [];
  const moving = cell.moving.value;
  const followed = followedLine(code.followed.value, tasks, moving);
  // Between two moves, and after the end of a task, the last line stays.
  const last = useRef<CodeLine | undefined>(undefined);
  const line = chosen ?? followed ?? last.current;
  last.current = line;
  const program = line && code.programOf(line);
  return (
    <section class="panel program" aria-label="Program">
      <ProgramTools cell={cell} line={line} program={program} />
      <CallPath cell={cell} tasks={tasks} />
      {line === undefined || program === undefined ? <p class="empty">{reason(line)}</p> : (
        <CodeTable
          program={program} marks={marksOf(program, tasks, moving)} onScrolled={() => { if (chosen === undefined) { code.stay(line); } }}
          revealed={{ line: line.line, isMarked: chosen?.isMarked === true, isFollowed: chosen === undefined, request: chosen }}
        />
      )}
    </section>
  );
}

/** Line of the followed task or of the arm. Before the line of a task are its calling lines, the first program first. */
function CallPath({ cell, tasks }: { cell: Cell; tasks: readonly TaskState[] }): JSX.Element {
  const followed = cell.code.followed.value;
  const task = followedTask(followed, tasks);
  const present = followedLine(followed, tasks, cell.moving.value);
  const lines = [...(task?.callers ?? []).toReversed(), ...(present === undefined ? [] : [present])];
  return (
    <nav class="call-path" aria-label="Calls">
      <span>{followed === "arm" ? "Arm" : (task?.name ?? "")}</span>
      <ol>
        {lines.map(({ program, line, file }, depth) => <li key={depth}><Place cell={cell} program={program} line={line} file={file} /></li>)}
      </ol>
    </nav>
  );
}

function reason(line: CodeLine | undefined): string {
  return line === undefined ? "No task exists." : `The code of ${line.program} is not available. Its file cannot be read.`;
}

interface ProgramToolsProps {
  cell: Cell;
  line: CodeLine | undefined;
  program: Program | undefined;
}

function ProgramTools({ cell, line, program }: ProgramToolsProps): JSX.Element {
  const { code, applicationName } = cell;
  const programs = code.programs.value;
  const groups = useMemo(() => groupsOf(programs, applicationName.value), [programs, applicationName.value]);
  const isFollowing = code.chosen.value === undefined;
  const shown = line === undefined || program === undefined ? "" : keyOf(line);
  const choose = (key: string): void => {
    const found = programs.get(key);
    if (found !== undefined) {
      code.showProgram(found);
    }
  };
  return (
    <div class="row tools">
      <select aria-label="Program" value={shown} onChange={({ currentTarget }) => choose(currentTarget.value)}>
        {shown === "" ? <option value="">{line?.program ?? "no program"}</option> : null}
        {groups.map(({ application, programs: own }) => (
          <optgroup key={application} label={application}>
            {own.map(({ name, file }) => <option key={file} value={keyOf({ program: name, file })}>{name}</option>)}
          </optgroup>
        ))}
      </select>
      <button type="button" aria-pressed={isFollowing} aria-label="Follow the execution" title="Show the line that is executed" onClick={() => (isFollowing && line !== undefined ? code.stay(line) : code.follow())}>Follow</button>
      <FollowedChoice cell={cell} />
      <span class="legend"><span class="arrow" aria-hidden="true">▶</span> executed line <span class="diamond" aria-hidden="true">◆</span> present move</span>
    </div>
  );
}

const TASK = "task ";

/** Choice of the task to follow, or of the arm. */
function FollowedChoice({ cell: { code, state } }: { cell: Cell }): JSX.Element {
  const tasks = state.value?.tasks ?? [];
  const followed = code.followed.value;
  const task = followedTask(followed, tasks);
  const value = followed === "arm" ? "arm" : task === undefined ? "" : TASK + task.name;
  return (
    <select aria-label="Followed task" value={value} onChange={({ currentTarget: { value: chosen } }) => code.follow(chosen === "arm" ? "arm" : { task: chosen.slice(TASK.length) })}>
      {value === "" ? <option value="">no task</option> : null}
      {tasks.map(({ name }) => <option key={name} value={TASK + name}>{name}</option>)}
      <option value="arm">Arm (present move)</option>
    </select>
  );
}
