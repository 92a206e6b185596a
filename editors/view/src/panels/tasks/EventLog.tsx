// Event log with its filter.

import type { JSX } from "preact";
import { useMemo, useState } from "preact/hooks";
import type { Cell } from "../shared/cell";
import { LongTable } from "../shared/LongTable";
import { Place } from "../shared/Place";
import { type Group, GROUPS, lineOf, rowClass, type RunEvent, shownEvents, textOf } from "./eventText";
import { faultOf } from "./faults";
import { countUpTo } from "./upTo";
import "./events.css";

const AT_FIRST: readonly Group[] = ["errors", "messages", "tasks", "robot", "moves", "clearance", "parts"];

export function EventLog({ cell }: { cell: Cell }): JSX.Element {
  const [groups, setGroups] = useState<ReadonlySet<Group>>(new Set(AT_FIRST));
  const [text, setText] = useState("");
  const [chosen, setChosen] = useState<RunEvent | undefined>(undefined);
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
        keyOf={(_, index) => index} rowClass={rowClass}
        isSelected={(event) => event === chosen} onRowClick={(event) => setChosen(event === chosen ? undefined : event)}
        cells={(event) => (
          <>
            <td><button type="button" class="place" title="Show this time" onClick={() => cell.seek(event.t)}>{event.t.toFixed(3)} s</button></td>
            <td>{event.task ?? ""}</td>
            <td title={textOf(event)}>{textOf(event)}</td>
          </>
        )}
      />
      {chosen === undefined ? null : <Whole cell={cell} event={chosen} onClose={() => setChosen(undefined)} />}
    </>
  );
}

/** The text of a clicked row, which the table may cut, with the remedy of a fault. */
function Whole({ cell, event, onClose }: { cell: Cell; event: RunEvent; onClose: () => void }): JSX.Element {
  const { code, help } = faultOf(event) ?? {};
  const line = lineOf(event);
  return (
    <div class="whole-event" role="region" aria-label="Event" tabIndex={0}>
      <button type="button" class="place" title="Show this time" onClick={() => cell.seek(event.t)}>{event.t.toFixed(3)} s</button>
      <button type="button" class="quiet" aria-label="Close the event" onClick={onClose}>×</button>
      <p>{textOf(event)}</p>
      {line === undefined ? null : <p>Line: <Place cell={cell} {...line} /></p>}
      {code === undefined ? null : <code>{code}</code>}
      {help === undefined ? null : <p>{help}</p>}
    </div>
  );
}
