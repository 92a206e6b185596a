// Configurations in which the arm reaches a point, and the button that moves the arm there by hand.

import type { JSX } from "preact";
import { useEffect, useMemo, useState } from "preact/hooks";
import { HoldButton } from "../pendant/HoldButton";
import { Holder } from "../pendant/Holder";
import { goStep } from "../pendant/jogSteps";
import { jogReason } from "../pendant/robotState";
import type { Cell, Notice } from "../shared/cell";
import { unitOf } from "../shared/lengths";
import { type PointName, pointText } from "./edits";
import { type ArmSolution, firstChoice, solutionsOf, solutionText } from "./solutions";
import { type ChosenTool, toolArguments } from "./tools";

interface Props {
  cell: Cell;
  notice: Notice;
  point: PointName;
  tool: ChosenTool;
}

export function GoTo({ cell, notice, point: { name, key }, tool }: Props): JSX.Element | null {
  const [solutions, setSolutions] = useState<readonly ArmSolution[]>([]);
  const [index, setIndex] = useState(-1);
  const holder = useMemo(() => new Holder(cell, notice), [cell, notice]);
  const blocked = cell.blocked.value;
  const toolName = tool === undefined ? cell.sample.value?.toolName : pointText(tool);
  useEffect(() => {
    let isCurrent = true;
    if (blocked === undefined) {
      void notice.send(cell, "solve", { name, key, ...toolArguments(tool) }).then((answer) => {
        if (isCurrent) {
          const found = answer === undefined ? [] : solutionsOf(answer);
          setSolutions(found);
          setIndex(firstChoice(found));
        }
      });
    }
    return () => { isCurrent = false; };
  }, [cell, notice, name, key, toolName, blocked]);
  const chosen = solutions[index];
  const target = chosen?.joints ?? undefined;
  // The picture shows the arm there until the choice is closed.
  useEffect(() => {
    const config = chosen?.config ?? undefined;
    cell.armGoal.value = blocked !== undefined || target === undefined ? undefined : { joints: target, text: `${pointText({ name, key })}${config === undefined ? "" : `: ${config}`}` };
    return () => { cell.armGoal.value = undefined; };
  }, [cell, target, name, key, blocked]);
  if (blocked !== undefined || solutions.length === 0) {
    return null;
  }
  const reason = target === undefined ? "The arm cannot reach it." : jogReason(cell.state.value, cell.armEnded.value);
  const label = `Go to ${pointText({ name, key })}`;
  return (
    <fieldset class="go-to">
      <legend>Reach</legend>
      <HoldButton label={label} holder={holder} notice={notice} reason={reason} step={goStep(target ?? [])}>Go to (hold)</HoldButton>
      {solutions.some(({ isChosen }) => isChosen) ? null : <p class="reason">movej cannot reach it with its configuration.</p>}
      {solutions.map((solution, at) => (
        <label key={solution.config ?? "joints"}>
          <input type="radio" name="solution" checked={at === index} disabled={solution.joints === null} onChange={() => setIndex(at)} />
          {" "}{solution.config ?? "joints"}{solution.isChosen && solution.config !== null ? " (movej)" : ""}: {solutionText(solution, cell.scene.value?.arm.axes ?? [], unitOf(cell.scene.value))}
        </label>
      ))}
    </fieldset>
  );
}
