// Chart of tasks, moves and waits over time.

import type { JSX, TargetedPointerEvent, TargetedWheelEvent } from "preact";
import { useEffect, useRef, useState } from "preact/hooks";
import { isDark } from "../../look";
import { paintCanvas } from "../shared/canvas";
import type { Cell } from "../shared/cell";
import { awaitsArm } from "./chart";
import { type Chart, chartHeight, draw, LABELS, LANE } from "./drawChart";
import { cutBlends, type MoveTimes, waitsInMoves } from "./moves";
import { type Range, shifted, zoomed } from "./range";

const LEGEND = [
  ["running", "computing"], ["waits", "waiting"], ["waits-arm", "waiting for the arm"], ["move", "move"], ["blend", "blend"], ["error", "error; ▼ a blend that did not happen"],
] as const;

export function TaskChart({ cell }: { cell: Cell }): JSX.Element {
  const canvas = useRef<HTMLCanvasElement>(null);
  const [width, setWidth] = useState(600);
  const [hint, setHint] = useState("");
  const drag = useRef<{ x: number; range: Range; isMoved: boolean } | undefined>(undefined);
  const time = cell.slowTime.value;
  const range = cell.range.value;
  const { segments, moves } = cell.history;
  // The canvas has the colours of the look in which it was painted.
  isDark.valueOf();
  const names = segments.names();
  const all = moves.all();
  const chart: Chart = { segments, moves: all, cut: new Set(cutBlends(all, time).map(({ move }) => move.id)), rests: waitsInMoves(cell.history.rests(), all, time), range, time };
  useResize(canvas, setWidth);
  useEffect(() => paintCanvas(canvas.current, width, chartHeight(names.length), (context, colour) => draw(context, width, chart, colour)));
  const timeAt = (clientX: number): number => {
    const left = canvas.current?.getBoundingClientRect().left ?? 0;
    return range[0] + ((clientX - left - LABELS) / Math.max(1, width - LABELS)) * (range[1] - range[0]);
  };
  const whole = cell.whole.value;
  const show = (next: Range): void => cell.setRange(next[0], next[1]);
  const move = (event: TargetedPointerEvent<HTMLCanvasElement>): void => {
    const { current } = drag;
    if (current === undefined) {
      setHint(hintAt(chart, timeAt(event.clientX), event.offsetY));
    } else if (current.isMoved || Math.abs(event.clientX - current.x) > 3) {
      current.isMoved = true;
      show(shifted(current.range, (current.x - event.clientX) / Math.max(1, width - LABELS), whole));
    }
  };
  const up = (event: TargetedPointerEvent<HTMLCanvasElement>): void => {
    if (drag.current?.isMoved === false) {
      cell.seek(Math.max(0, timeAt(event.clientX)));
    }
    drag.current = undefined;
  };
  const wheel = (event: TargetedWheelEvent<HTMLCanvasElement>): void => {
    if (event.ctrlKey || event.shiftKey) {
      event.preventDefault();
      show(zoomed(range, event.deltaY + event.deltaX > 0 ? 1.25 : 0.8, timeAt(event.clientX), whole));
    }
  };
  const middle = (range[0] + range[1]) / 2;
  return (
    <div class="chart">
      <div class="row tools" role="group" aria-label="Range of the chart">
        <strong>{range[0].toFixed(2)} s to {range[1].toFixed(2)} s</strong>
        <button type="button" aria-label="Earlier" onClick={() => show(shifted(range, -0.25, whole))}>◀</button>
        <button type="button" aria-label="Later" onClick={() => show(shifted(range, 0.25, whole))}>▶</button>
        <button type="button" aria-label="Zoom in" onClick={() => show(zoomed(range, 0.5, middle, whole))}>+</button>
        <button type="button" aria-label="Zoom out" onClick={() => show(zoomed(range, 2, middle, whole))}>−</button>
        <button type="button" onClick={() => show(whole)}>All</button>
        <span class="legend">{LEGEND.map(([name, text]) => <span key={name}><span class={`swatch chart-${name}`} aria-hidden="true" />{text}</span>)}</span>
      </div>
      <canvas
        ref={canvas} role="img" aria-label={`Chart of ${names.length} tasks and ${all.length} moves. The tables below have the waits and the blends that did not happen.`}
        height={chartHeight(names.length)} onPointerMove={move} onPointerUp={up} onWheel={wheel} onPointerLeave={() => { drag.current = undefined; setHint(""); }}
        onPointerDown={(event) => { drag.current = { x: event.clientX, range, isMoved: false }; }}
      />
      <p class="hint">{hint || "Drag to move, Shift or Ctrl and the wheel to zoom, click to show a time."}</p>
    </div>
  );
}

function useResize(canvas: { readonly current: HTMLCanvasElement | null }, setWidth: (width: number) => void): void {
  useEffect(() => {
    const box = canvas.current?.parentElement;
    if (!box) {
      return undefined;
    }
    const observer = new ResizeObserver(() => setWidth(Math.max(200, box.clientWidth)));
    observer.observe(box);
    return () => observer.disconnect();
  }, [canvas, setWidth]);
}

/** Formats the bar at a location of the chart. */
function hintAt({ segments, moves, rests, time, cut }: Chart, t: number, y: number): string {
  const lane = Math.floor(y / LANE);
  if (t > time || lane < 0) {
    return "";
  }
  if (lane === 0) {
    const move = moves.findLast(({ started, done }) => (started ?? Infinity) <= t && (done ?? Infinity) >= t);
    const rest = rests.find(({ start, end }) => start <= t && t < end);
    const wait = rest === undefined ? "" : `, waits${rest.reason === "next move" ? " for the next move" : rest.reason === "" ? "" : ` (${rest.reason})`}`;
    return move === undefined ? "" : `${move.type} ${move.id} at ${move.program}:${move.line}${cut.has(move.id) ? ", without its blend" : ""}${wait}`;
  }
  const name = segments.names()[lane - 1];
  const segment = name === undefined ? undefined : segments.of(name).find(({ start, end }) => start <= t && t < end);
  if (segment === undefined) {
    return "";
  }
  const until = Math.min(segment.end, time);
  const activity = segment.waits === null ? segment.state : `waits for ${segment.waits}`;
  const ended = awaitsArm(segment) && segment.end <= time ? `, until the move at ${endingMove(moves, segment.end)}` : "";
  return `${name} ${activity} at ${segment.program}:${segment.line}, ${(until - segment.start).toFixed(2)} s${ended}`;
}

/** Formats the last move that ended before the end of a wait for the arm. */
function endingMove(moves: readonly MoveTimes[], end: number): string {
  const move = moves.findLast(({ done }) => (done ?? Infinity) <= end + 0.1);
  return move === undefined ? "an unknown line" : `${move.program}:${move.line}`;
}
