// Fields for a joint position, and the button that moves the arm there by hand.

import type { JSX } from "preact";
import { useState } from "preact/hooks";
import { fieldText } from "../points/edits";
import type { Cell, Notice } from "../shared/cell";
import { unitOf } from "../shared/lengths";
import type { ArmChain } from "./armModel";
import { HoldButton } from "./HoldButton";
import type { Holder } from "./Holder";
import { enteredJoints } from "./enteredJoints";
import { goStep } from "./jogSteps";

interface Props {
  cell: Cell;
  notice: Notice;
  holder: Holder;
  axes: ArmChain["axes"];
  /** Reason why the arm cannot be jogged. */
  reason: string | undefined;
}

export function JointEntry({ cell, notice, holder, axes, reason }: Props): JSX.Element {
  const [texts, setTexts] = useState<readonly string[]>();
  const unit = unitOf(cell.scene.value);
  const present = (): string[] => axes.map(({ isLinear }, axis) => fieldText((cell.sample.peek()?.joints[axis] ?? 0) / (isLinear ? unit.mm : 1), isLinear, unit));
  if (texts === undefined) {
    return <button type="button" class="enter-joints" onClick={() => setTexts(present())}>Enter joints…</button>;
  }
  const entered = enteredJoints(axes, texts, unit);
  const refusal = "refusal" in entered ? entered.refusal : undefined;
  return (
    <div class="joint-entry" role="group" aria-label="Joints to go to">
      <div class="row">
        {axes.map(({ isLinear }, axis) => (
          <label key={axis}>J{axis + 1}{isLinear && unit.mm !== 1 ? ` (${unit.short})` : ""}{" "}
            <input inputMode="decimal" value={texts[axis]} onInput={({ currentTarget }) => setTexts(texts.with(axis, currentTarget.value))} />
          </label>
        ))}
      </div>
      {refusal === undefined ? null : <p class="reason" role="status">{refusal}</p>}
      <div class="row">
        <HoldButton label="Go to the entered joints" {...{ holder, notice }} reason={refusal ?? reason} step={goStep("joints" in entered ? entered.joints : [])}>Go to (hold)</HoldButton>
        <button type="button" onClick={() => setTexts(present())}>Joints of the arm</button>
        <button type="button" onClick={() => setTexts(undefined)}>Close</button>
      </div>
    </div>
  );
}
