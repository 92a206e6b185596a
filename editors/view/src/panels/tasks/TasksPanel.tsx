// Tasks and time: the tasks, a chart, the motion queue, the event log, smallest distances, and times by program line.

import type { JSX } from "preact";
import { ClearanceTable } from "../clearance/ClearanceTable";
import type { Cell } from "../shared/cell";
import { Tabs } from "../shared/Tabs";
import { EventLog } from "./EventLog";
import { MotionQueue } from "./MotionQueue";
import { TaskChart } from "./TaskChart";
import { TaskTable } from "./TaskTable";
import { TimesTable } from "./TimesTable";
import { WaitTables } from "./WaitTables";

export function TasksPanel({ cell }: { cell: Cell }): JSX.Element {
  return (
    <section class="panel tasks" aria-label="Tasks and time">
      <Tabs
        label="Tasks and time"
        tabs={[
          { id: "waits", label: "Tasks", content: () => <div class="scroll" tabIndex={0} role="region" aria-label="Tasks and waits"><TaskTable cell={cell} /><TaskChart cell={cell} /><WaitTables cell={cell} /></div> },
          { id: "queue", label: "Motion queue", content: () => <MotionQueue cell={cell} /> },
          { id: "log", label: "Event log", content: () => <EventLog cell={cell} /> },
          { id: "clearance", label: "Distances", content: () => <ClearanceTable cell={cell} /> },
          { id: "times", label: "Times", content: () => <TimesTable cell={cell} /> },
        ]}
      />
    </section>
  );
}
