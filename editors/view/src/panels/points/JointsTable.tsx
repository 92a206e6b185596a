// Joint positions of the application, and the editor of the selected one.

import type { JSX } from "preact";
import type { Cell, JointValue, Notice } from "../shared/cell";
import { unitOf } from "../shared/lengths";
import { fieldText, pointText, samePoint } from "./edits";
import { GoTo } from "./GoTo";
import { ReachMark } from "./ReachMark";
import { TeachButton } from "./TeachButton";

interface Props {
  cell: Cell;
  notice: Notice;
  joints: readonly JointValue[];
  /** Reasons why the arm cannot reach values, by name. */
  reach: ReadonlyMap<string, string>;
}

export function JointsTable({ cell, notice, joints, reach }: Props): JSX.Element | null {
  if (joints.length === 0) {
    return null;
  }
  const selected = cell.selectedPoint.value;
  const present = selected && joints.find((joint) => samePoint(joint, selected));
  const axes = cell.scene.value?.arm.axes ?? [];
  const unit = unitOf(cell.scene.value);
  return (
    <>
      <div class="joint-table" tabIndex={0} role="region" aria-label="Joint positions of the application">
        <table aria-label="Joint positions of the application">
          <thead>
            <tr><th scope="col">Joint position</th>{axes.map(({ isLinear }, axis) => <th class="figure" scope="col" key={axis}>J{axis + 1}{isLinear && unit.mm !== 1 ? ` (${unit.short})` : ""}</th>)}</tr>
          </thead>
          <tbody>
            {joints.map((joint) => <JointRow key={pointText(joint)} cell={cell} joint={joint} reason={reach.get(pointText(joint))} isSelected={joint === present} />)}
          </tbody>
        </table>
      </div>
      {present === undefined ? null : (
        <div class="point-editor" role="group" aria-label={`Values of ${pointText(present)}`}>
          <p><strong>{pointText(present)}</strong></p>
          <div class="row"><TeachButton cell={cell} notice={notice} point={present} tool={undefined} details="joints of the arm" /></div>
          <GoTo key={`${pointText(present)} ${present.values.join()}`} cell={cell} notice={notice} point={present} tool={undefined} />
        </div>
      )}
    </>
  );
}

function JointRow({ cell, joint, reason, isSelected }: { cell: Cell; joint: JointValue; reason: string | undefined; isSelected: boolean }): JSX.Element {
  const [axes, unit] = [cell.scene.value?.arm.axes ?? [], unitOf(cell.scene.value)];
  const isEdited = cell.unsaved.value.has(pointText(joint));
  const select = (): void => cell.selectPoint({ name: joint.name, key: joint.key });
  return (
    <tr class={isEdited ? "changed" : undefined} aria-current={isSelected ? true : undefined} onClick={select}>
      <th scope="row"><button type="button" class="place" onClick={select}>{pointText(joint)}</button>{isEdited ? <span class="edited"> changed</span> : null}<ReachMark reason={reason} /></th>
      {joint.values.map((value, axis) => <td class="figure" key={axis}>{fieldText(value, axes[axis]?.isLinear ?? false, unit)}</td>)}
    </tr>
  );
}
