// Jogging: the axes with their limits, and buttons for joint and Cartesian steps.

import type { JSX } from "preact";
import { useMemo, useState } from "preact/hooks";
import { pointText } from "../points/edits";
import { ToolChoice } from "../points/ToolChoice";
import { handTool } from "../points/tools";
import type { Cell, CellPoint, CellScene, Notice } from "../shared/cell";
import { flangeAt } from "./armModel";
import { JointEntry } from "./JointEntry";
import { HoldButton } from "./HoldButton";
import { Holder, type Step } from "./Holder";
import { cartesianStep, FIRST_STEP, fraction, type JogStep, jointStep, stepsIn } from "./jogSteps";
import { composed, type Frame, frameOf, inverse, poseOf } from "./pose";
import { jogReason } from "./robotState";
import { fixed } from "../shared/fixed";
import { lengthFigure, lengthText, type LengthUnit, unitOf } from "../shared/lengths";

const DIRECTIONS = ["X", "Y", "Z", "RX", "RY", "RZ"] as const;

interface Props {
  cell: Cell;
  notice: Notice;
}

export function JogControls({ cell, notice }: Props): JSX.Element | null {
  const [way, setWay] = useState("joint");
  const [chosenStep, setStep] = useState(FIRST_STEP);
  const holder = useMemo(() => new Holder(cell, notice), [cell, notice]);
  const scene = cell.scene.value;
  if (scene === undefined) {
    return null;
  }
  const reason = cell.blocked.value ?? jogReason(cell.state.value, cell.armEnded.value);
  const unit = unitOf(scene);
  const steps = stepsIn(unit);
  const step: JogStep = steps[chosenStep] ?? { length: 1, angle: 1 };
  const controls = { cell, notice, scene, holder, step, unit, reason };
  return (
    <fieldset class="jog">
      <legend title={reason}>Jog{reason === undefined ? null : <span class="reason"> – {reason}</span>}</legend>
      <div class="row">
        <label>Along{" "}
          <select value={way} onChange={({ currentTarget }) => setWay(currentTarget.value)}>
            <option value="joint">the joints</option>
            <option value="world">world</option>
            <option value="tool">the tool</option>
            {cell.frames.value.map(pointText).map((name) => <option key={name} value={`frame:${name}`}>{name}</option>)}
          </select>
        </label>
        <ToolChoice cell={cell} />
        <label>Step{" "}
          <select value={chosenStep} onChange={({ currentTarget }) => setStep(Number(currentTarget.value))}>
            {steps.map(({ text }, index) => <option key={text} value={index}>{text}</option>)}
          </select>
        </label>
      </div>
      <Axes {...controls} hasButtons={way === "joint"} />
      {way === "joint" ? <JointEntry {...controls} axes={scene.arm.axes} /> : <Directions {...controls} way={way} />}
    </fieldset>
  );
}

interface ControlProps extends Props {
  scene: CellScene;
  holder: Holder;
  step: JogStep;
  unit: LengthUnit;
  reason: string | undefined;
}

function Axes({ cell, notice, scene, holder, step, unit, reason, hasButtons }: ControlProps & { hasButtons: boolean }): JSX.Element {
  const joints = cell.sample.value?.joints ?? [];
  return (
    <div class="axes">
      {scene.arm.axes.map(({ isLinear, min, max }, axis) => {
        const [value, name] = [joints[axis] ?? 0, `J${axis + 1}`];
        const size = isLinear ? step.length : step.angle;
        const figure = (part: number, digits: number): string => (isLinear ? lengthFigure(part, digits, unit) : fixed(part, digits));
        const button = (sign: 1 | -1): JSX.Element | null => hasButtons
          ? <HoldButton label={`${name} ${sign > 0 ? "plus" : "minus"}`} {...{ holder, reason, notice }} step={(from) => jointStep(scene.arm, from, axis, sign * size)}>{sign > 0 ? "+" : "−"}</HoldButton>
          : null;
        return (
          <div class="axis" key={axis}>
            <span class="axis-name">{name}</span>
            {button(-1)}
            <div class="bar" role="meter" aria-label={`${name} in ${isLinear ? unit.long : "degrees"}`} aria-valuemin={Number(figure(min, 2))} aria-valuemax={Number(figure(max, 2))} aria-valuenow={Number(figure(value, 2))}>
              <span class="bar-mark" style={{ left: `${fraction(value, min, max) * 100}%` }} />
              <span class="bar-limit">{Number(figure(min, 1))}</span>
              <span class="bar-limit">{Number(figure(max, 1))}</span>
            </div>
            {button(1)}
            <output class={`value ${isNearLimit(value, min, max) ? "at-limit" : ""}`}>{figure(value, 2)} {isLinear ? unit.short : "°"}</output>
          </div>
        );
      })}
    </div>
  );
}

function isNearLimit(value: number, min: number, max: number): boolean {
  return fraction(value, min, max) < 0.02 || fraction(value, min, max) > 0.98;
}

function Directions({ cell, notice, scene, holder, step, unit, reason, way }: ControlProps & { way: string }): JSX.Element {
  const sample = cell.sample.value;
  const [base, tool] = [frameOf(scene.base), frameOf(handTool(cell).pose)];
  const world = composed(base, composed(flangeAt(scene.arm, sample?.joints ?? []), tool));
  const frame = frameOfWay(cell.frames.value, way);
  const pose = poseOf(frame === undefined ? world : composed(inverse(frame), world));
  return (
    <div class="axes">
      {DIRECTIONS.map((name, direction) => {
        const move = (sign: 1 | -1): Step => (from) => cartesianStep(scene.arm, from, { direction, step: sign * (direction < 3 ? step.length : step.angle), frame, base, tool });
        const button = (sign: 1 | -1): JSX.Element => <HoldButton label={`${name} ${sign > 0 ? "plus" : "minus"}`} {...{ holder, reason, notice }} step={move(sign)}>{sign > 0 ? "+" : "−"}</HoldButton>;
        return (
          <div class="axis cartesian" key={name}>
            <span class="axis-name">{name}</span>
            {button(-1)}
            <output class="value">{direction < 3 ? lengthText(pose[direction] ?? 0, 2, unit) : `${fixed(pose[direction] ?? 0, 2)} °`}</output>
            {button(1)}
          </div>
        );
      })}
    </div>
  );
}

/** Returns the frame along whose axes the arm is jogged; `undefined` for the tool's axes. */
function frameOfWay(frames: readonly CellPoint[], way: string): Frame | undefined {
  const name = way.startsWith("frame:") ? way.slice("frame:".length) : "";
  return way === "tool" ? undefined : frameOf(frames.find((frame) => pointText(frame) === name)?.pose ?? []);
}
