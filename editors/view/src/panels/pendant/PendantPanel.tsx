// Pendant: its user page, its keys, the switches of the robot, and jogging.

import type { JSX } from "preact";
import { useMemo } from "preact/hooks";
import { type Cell, Notice } from "../shared/cell";
import { NoticeLine } from "../shared/NoticeLine";
import { JogControls } from "./JogControls";
import { Keypad } from "./Keypad";
import { RobotControls } from "./RobotControls";
import { UserPage } from "./UserPage";

export function PendantPanel({ cell }: { cell: Cell }): JSX.Element {
  const notice = useMemo(() => new Notice(), []);
  const { blocked } = cell;
  return (
    <section class="panel pendant" aria-label="Pendant">
      {blocked.value === undefined ? null : <p class="blocked">{blocked.value}</p>}
      <NoticeLine notice={notice} />
      <div class="mcp">
        <UserPage cell={cell} notice={notice} />
        <RobotControls cell={cell} notice={notice} />
        <Keypad cell={cell} notice={notice} />
        <JogControls cell={cell} notice={notice} />
      </div>
    </section>
  );
}
