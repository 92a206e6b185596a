// Pendant: its user page, its keys, the switches of the robot, and jogging.

import type { JSX } from "preact";
import { useMemo } from "preact/hooks";
import { Fold } from "../../layout/Fold";
import { type Cell, Notice } from "../shared/cell";
import { MessageLine } from "../shared/NoticeLine";
import { JogControls } from "./JogControls";
import { Keypad } from "./Keypad";
import { RobotControls } from "./RobotControls";
import { stopText } from "./robotState";
import { UserPage } from "./UserPage";

export function PendantPanel({ cell }: { cell: Cell }): JSX.Element {
  const notice = useMemo(() => new Notice(), []);
  const isManual = cell.state.value?.mode === "manual";
  const userPage = <Fold key="screen" name="userPage" label="User page" className="screen-part" isOpenAtFirst={isUsed(cell)}><UserPage cell={cell} notice={notice} /></Fold>;
  return (
    <section class="panel pendant" aria-label="Pendant">
      <MessageLine cell={cell} notice={notice} state={stopText(cell.state.value)} />
      <div class="mcp">
        {/* In manual mode, jogging comes before the user page, so that small windows show it without scrolling. */}
        {isManual ? null : userPage}
        <RobotControls key="robot" cell={cell} notice={notice} />
        <JogControls key="jog" cell={cell} notice={notice} />
        {isManual ? userPage : null}
        <Fold key="keypad" name="keypad" label="Keys of the pendant" className="keypad-part" isOpenAtFirst={false}><Keypad cell={cell} notice={notice} /></Fold>
      </div>
    </section>
  );
}

/** Whether a program has written to the user page. VS Code shows its text in a separate view. */
function isUsed({ page: { value: page }, openLine }: Cell): boolean {
  const hasText = page !== undefined && (page.title !== "" || page.lines.some((line) => line.trim() !== ""));
  return page?.html != null || page?.popUp != null || (hasText && openLine.value === undefined);
}
