// Event log with its filter.

import type { JSX } from "preact";
import { useMemo, useState } from "preact/hooks";
import type { Cell } from "../shared/cell";
import { LongTable } from "../shared/LongTable";
import { type Group, groupOf, GROUPS, type RunEvent, shownEvents, textOf } from "./eventText";
import { countUpTo } from "./upTo";

const AT_FIRST: readonly Group[] = ["errors", "messages", "tasks", "robot", "moves", "clearance", "parts"];

export function EventLog({ cell }: { cell: Cell }): JSX.Element {
  const [groups, setGroups] = useState<ReadonlySet<Group>>(new Set(AT_FIRST));
  const [text, setText] = useState("");
  const count = countUpTo(cell.history.events, cell.slowTime.value);
  const events = useMemo(() => shownEvents(cell.history.events.slice(0, count), { groups, text }), [cell, count, groups, text]);
  const toggle = (group: Group): void => {
    const next = new Set(groups);
    if (!next.delete(group)) {
      next.add(group);
    }
    setGroups(next);
  };
  return (
    <>
      <div class="row tools">
        <input type="search" aria-label="Filter events" placeholder="Filter" value={text} onInput={({ currentTarget }) => setText(currentTarget.value)} />
        <fieldset class="groups">
          <legend class="hidden">Kinds of events</legend>
          {GROUPS.map(([group, label]) => <label key={group}><input type="checkbox" checked={groups.has(group)} onChange={() => toggle(group)} /> {label}</label>)}
        </fieldset>
        <span class="count" role="status">{events.length} of {count}</span>
      </div>
      <LongTable<RunEvent>
        label="Event log" className="events" columns={["Time", "Task", "Event"]} rows={events} followsEnd empty="No event up to the shown time."
        keyOf={(_, index) => index} rowClass={(event) => groupOf(event)}
        cells={(event) => (
          <>
            <td><button type="button" class="place" title="Show this time" onClick={() => cell.seek(event.t)}>{event.t.toFixed(3)} s</button></td>
            <td>{event.task ?? ""}</td>
            <td title={textOf(event)}>{textOf(event)}</td>
          </>
        )}
      />
    </>
  );
}
