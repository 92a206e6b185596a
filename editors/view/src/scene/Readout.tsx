// Pose of the tool centre point, joints and speed over the drawing.

import type { JSX } from "preact";
import { poseOf } from "../panels/pendant/pose";
import { handTool } from "../panels/points/tools";
import type { Store } from "../store";
import type { Viewport } from "./Viewport";
import { fixed } from "../panels/shared/fixed";
import { lengthFigure, lengthText, type LengthUnit, unitOf } from "../panels/shared/lengths";

/** Speed in mm/s below which the arm counts as resting: the readout shows 0. */
const AT_REST = 0.5;

export function Readout({ store, view }: { store: Store; view: Viewport | undefined }): JSX.Element {
  const sample = store.shown.value;
  // Without a run, the drawing shows the arm at zero.
  const axes = store.scene.value?.arm.axes ?? [];
  const joints = sample?.joints ?? axes.map(() => 0);
  const unit = unitOf(store.scene.value);
  const tool = handTool(store.panels.cell);
  const pose = view && store.scene.value ? poseOf(view.tcp) : [];
  return (
    <dl class="position" aria-label="Tool centre point in world, joints and speed">
      {["X", "Y", "Z", "RX", "RY", "RZ"].map((name, axis) => <div key={name}><dt>{name}</dt><dd>{axis < 3 ? length(pose[axis], unit) : figure(pose[axis], 1)}</dd></div>)}
      {joints.map((value, axis) => <div key={axis} class="joint"><dt>J{axis + 1}</dt><dd>{axes[axis]?.isLinear === true ? length(value, unit) : figure(value, 2)}</dd></div>)}
      {unit.mm === 1 ? null : <div class="wide"><dt>Lengths</dt><dd>{unit.long}</dd></div>}
      {sample === undefined && tool.isOfLastMove ? null : <div class="wide"><dt>Tool</dt><dd>{tool.name ?? "of the last move"}</dd></div>}
      {sample === undefined ? null : <div class="wide"><dt>Speed</dt><dd>{lengthText(sample.speed, 0, unit)}/s</dd></div>}
      {sample === undefined ? null : <div class="wide"><dt>{sample.speed < AT_REST ? "At rest" : "Limited by"}</dt><dd>{limitName(store, sample.limit) ?? "–"}</dd></div>}
    </dl>
  );
}

/** Returns the name of a speed limit. */
export function limitName(store: Store, limit: number | undefined): string | undefined {
  return limit === undefined ? undefined : store.scene.value?.limits[limit];
}

/** Formats a length in mm for the readout. */
function length(value: number | undefined, unit: LengthUnit): string {
  return value === undefined ? "–" : lengthFigure(value, 2, unit);
}

/** Formats a number of the readout. */
function figure(value: number | undefined, digits: number): string {
  return value === undefined ? "–" : fixed(value, digits);
}
