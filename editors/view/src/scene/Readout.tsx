// Pose of the tool centre point, joints and speed over the drawing.

import type { JSX } from "preact";
import { poseOf } from "../panels/pendant/pose";
import { handTool } from "../panels/points/tools";
import type { Store } from "../store";
import type { Viewport } from "./Viewport";
import { fixed } from "../panels/shared/fixed";

/** Speed in mm/s below which the arm counts as resting: the readout shows 0. */
const AT_REST = 0.5;

export function Readout({ store, view }: { store: Store; view: Viewport | undefined }): JSX.Element {
  const sample = store.shown.value;
  // Without a run, the drawing shows the arm at zero.
  const joints = sample?.joints ?? store.scene.value?.arm.axes.map(() => 0) ?? [];
  const tool = handTool(store.panels.cell);
  const pose = view && store.scene.value ? poseOf(view.tcp) : [];
  return (
    <dl class="position" aria-label="Tool centre point in world, joints and speed">
      {["X", "Y", "Z", "RX", "RY", "RZ"].map((name, axis) => <div key={name}><dt>{name}</dt><dd>{figure(pose[axis], axis < 3 ? 2 : 1)}</dd></div>)}
      {joints.map((value, axis) => <div key={axis} class="joint"><dt>J{axis + 1}</dt><dd>{figure(value, 2)}</dd></div>)}
      {sample === undefined && tool.isOfLastMove ? null : <div class="wide"><dt>Tool</dt><dd>{tool.name ?? "of the last move"}</dd></div>}
      {sample === undefined ? null : <div class="wide"><dt>Speed</dt><dd>{sample.speed.toFixed(0)} mm/s</dd></div>}
      {sample === undefined ? null : <div class="wide"><dt>{sample.speed < AT_REST ? "At rest" : "Limited by"}</dt><dd>{limitName(store, sample.limit) ?? "–"}</dd></div>}
    </dl>
  );
}

/** Returns the name of a speed limit. */
export function limitName(store: Store, limit: number | undefined): string | undefined {
  return limit === undefined ? undefined : store.scene.value?.limits[limit];
}

/** Formats a number of the readout. */
function figure(value: number | undefined, digits: number): string {
  return value === undefined ? "–" : fixed(value, digits);
}
