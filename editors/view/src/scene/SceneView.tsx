// Drawing of the cell with its buttons, its legend, and the selected object.

import { effect, untracked } from "@preact/signals";
import type { JSX, TargetedPointerEvent } from "preact";
import { useEffect, useRef, useState } from "preact/hooks";
import { armFrames } from "../kinematics";
import { isDark } from "../look";
import { composed, frameOf, poseOf } from "../panels/pendant/pose";
import { pointText } from "../panels/points/edits";
import { openingOf } from "../panels/shared/opening";
import { handTool } from "../panels/points/tools";
import { lengthFigure, lengthText, type LengthUnit, poseTexts, unitOf } from "../panels/shared/lengths";
import type { Store } from "../store";
import { LayerChoice } from "./LayerChoice";
import { hiddenLayers } from "./layers";
import { Legend } from "./Legend";
import { pick, type Picked } from "./picking";
import { hasReach } from "./reach";
import { limitName, Readout } from "./Readout";
import { ViewChoice } from "./ViewChoice";
import { Viewport } from "./Viewport";
import "./scene.css";

declare global {
  interface Window {
    /** The page, for its tests. */
    val3View?: {
      store: Store;
      pose: () => number[];
      stats: () => { drawCalls: number; frames: number };
      /** Corners around the parts of the arm, in world. */
      outline: () => number[][];
      /** Location of a position in the picture, in px. */
      locationOf: (position: readonly number[]) => readonly number[];
    };
  }
}

export function SceneView({ store }: { store: Store }): JSX.Element {
  const host = useRef<HTMLDivElement>(null);
  const canvas = useRef<HTMLCanvasElement>(null);
  const overlay = useRef<HTMLDivElement>(null);
  const [view, setView] = useState<Viewport>();
  const [failure, setFailure] = useState<string>();
  const [picked, setPicked] = useState<Picked>();
  const [measured, setMeasured] = useState<readonly (readonly number[])[]>();
  const [isFollowing, setFollowing] = useState(false);
  const [isReach, setReach] = useState(false);
  useEffect(() => (host.current && canvas.current && overlay.current ? begin(host.current, canvas.current, overlay.current, store, setView, setFailure) : undefined), [store]);
  const cell = store.scene.value;
  const tool = handTool(store.panels.cell).name ?? "the last move's tool";
  const take = (event: TargetedPointerEvent<HTMLCanvasElement>): void => {
    const found = view && pick(event.offsetX, event.offsetY, [event.currentTarget.clientWidth, event.currentTarget.clientHeight], view.camera.lens, store.panels.cell.points.peek(), view.trail);
    setPicked(found);
    if (view && measured !== undefined) {
      const at = found?.at ?? view.surfaceAt(event.offsetX, event.offsetY);
      const ends = at === undefined ? measured : measured.length === 1 ? [...measured, at] : [at];
      view.measured = ends;
      setMeasured(ends);
      view.update();
      return;
    }
    if (found !== undefined && "point" in found) {
      store.selection.value = { kind: "point", point: { name: found.point.name, key: found.point.key } };
    }
  };
  const measure = (): void => {
    if (view) {
      view.measured = [];
      view.update();
    }
    setMeasured(measured === undefined ? [] : undefined);
  };
  const follow = (): void => {
    if (view) {
      view.isFollowing = !isFollowing;
    }
    setFollowing(!isFollowing);
  };
  const showReach = (): void => {
    view?.showReach(!isReach);
    setReach(!isReach);
  };
  const press = useRef<readonly [number, number]>([0, 0]);
  return (
    <section class="picture" aria-label="Picture of the cell" ref={host}>
      <canvas
        ref={canvas} tabIndex={0} role="img" aria-label="The arm in its cell. Arrow keys turn the picture, plus and minus zoom, F fits it."
        onKeyDown={(event) => view && turn(view, event)}
        onPointerDown={({ clientX, clientY }) => (press.current = [clientX, clientY])}
        onPointerUp={(event) => (Math.hypot(event.clientX - press.current[0], event.clientY - press.current[1]) < 4 ? take(event) : undefined)}
      />
      <div class="names" ref={overlay} aria-hidden="true" />
      {failure === undefined ? null : <p class="failure" role="alert">{failure}</p>}
      {view === undefined || view.faults.value.length === 0 ? null : <ul class="faults" role="status">{view.faults.value.map((fault) => <li key={fault}>{fault}</li>)}</ul>}
      <div class="picture-tools" role="toolbar" aria-label="Picture">
        <ViewChoice onChoose={(name) => view?.choose(name)} />
        <button type="button" title="Show everything" onClick={() => view?.choose()}>Fit</button>
        <button type="button" aria-pressed={isFollowing} title="Keep the tool centre point at its place" onClick={follow}>Follow</button>
        <button type="button" aria-pressed={measured !== undefined} title="Distance between two clicked positions" onClick={measure}>Measure</button>
        {cell && hasReach(cell.arm) ? <button type="button" aria-pressed={isReach} title={`The farthest positions of ${tool}`} onClick={showReach}>Reach</button> : null}
        <LayerChoice />
      </div>
      <div class="foot">
        <Legend store={store} view={view} reachOf={isReach ? tool : undefined} />
        <Readout store={store} view={view} />
      </div>
      <div class="picked" role="status">
        {measured === undefined ? <PickedText store={store} picked={picked} /> : <MeasureText ends={measured} unit={unitOf(cell)} />}
      </div>
    </section>
  );
}

function PickedText({ store, picked }: { store: Store; picked: Picked | undefined }): JSX.Element | null {
  if (picked === undefined) {
    return null;
  }
  const unit = unitOf(store.scene.value);
  const numbers = poseTexts(picked.at.slice(0, 6), 2, unit).join(", ");
  if ("point" in picked) {
    const { father, config } = picked.point;
    return <><strong>{pointText(picked.point)}</strong> <span>{numbers}{father === null ? "" : `, in ${father}`}{config ? `, ${config}` : ""}</span></>;
  }
  const { piece, t } = picked;
  const source = piece.source === undefined ? undefined : store.sources.get(piece.source);
  const opening = source && openingOf(store.panels.cell, source);
  const line = source && `${source.program}:${source.line}`;
  return (
    <>
      {opening ? <button type="button" title={opening.title} onClick={opening.open}>{line}</button> : <strong>{line ?? "No line"}</strong>}
      {" "}<span>{source?.instruction} at {t.toFixed(3)} s, {lengthText(piece.speed, 0, unit)}/s, limited by {limitName(store, piece.limit) ?? "–"}: {numbers}</span>
      {" "}<button type="button" onClick={() => (store.chosen.value = t)}>Show this time</button>
    </>
  );
}

function MeasureText({ ends: [from, to], unit }: { ends: readonly (readonly number[])[]; unit: LengthUnit }): JSX.Element {
  if (from === undefined || to === undefined) {
    return <span>{from === undefined ? "Click the first position." : "Click the second position."}</span>;
  }
  const way = [0, 1, 2].map((axis) => (to[axis] ?? 0) - (from[axis] ?? 0));
  return <><strong>{lengthText(Math.hypot(...way), 3, unit)}</strong> <span>{way.map((value, axis) => `d${"xyz"[axis] ?? ""} ${lengthFigure(value, 3, unit)}`).join("  ")}</span></>;
}

/** Returns the tool centre point in world at the shown time. */
function shownPose(store: Store): number[] {
  const [cell, sample] = [store.scene.peek(), store.panels.cell.sample.peek()];
  return cell && sample ? poseOf(composed(armFrames(cell.arm, frameOf(cell.base), sample.joints).flange, frameOf(sample.tool))) : [];
}

function turn(view: Viewport, event: KeyboardEvent): void {
  const turns: Record<string, readonly [number, number, number?]> = {
    ArrowLeft: [-10, 0], ArrowRight: [10, 0], ArrowUp: [0, 8], ArrowDown: [0, -8], "+": [0, 0, 0.85], "-": [0, 0, 1.18],
  };
  const found = turns[event.key];
  if (found !== undefined) {
    view.turn(...found);
  } else if (event.key === "f") {
    view.choose();
  } else {
    return;
  }
  event.preventDefault();
  event.stopPropagation();
}

function begin(host: HTMLElement, canvas: HTMLCanvasElement, overlay: HTMLElement, store: Store, use: (view: Viewport) => void, fail: (reason: string) => void): (() => void) | undefined {
  const page = { store, pose: () => shownPose(store) };
  window.val3View = { ...page, stats: () => ({ drawCalls: 0, frames: 0 }), outline: () => [], locationOf: () => [] };
  let view: Viewport;
  try {
    view = new Viewport(canvas, overlay, store);
  } catch {
    fail("This browser has no WebGL, so the cell is not drawn. The panels work without it.");
    return undefined;
  }
  window.val3View = {
    ...page, stats: () => ({ drawCalls: view.drawCalls, frames: view.frames }), outline: () => view.outline(), locationOf: (position) => view.locationOf(position),
  };
  const observer = new ResizeObserver(() => view.resize(host.clientWidth, host.clientHeight));
  observer.observe(host);
  view.resize(host.clientWidth, host.clientHeight);
  const stops = [
    effect(() => {
      const cell = store.scene.value;
      const dark = isDark.value;
      if (cell !== undefined) {
        // The drawing depends on the shown time, its static parts do not.
        untracked(() => view.build(cell, dark));
      }
    }),
    effect(() => {
      store.sampleCount.valueOf();
      hiddenLayers.valueOf();
      view.update();
    }),
  ];
  use(view);
  return () => {
    observer.disconnect();
    stops.forEach((stop) => stop());
    view.dispose();
  };
}
