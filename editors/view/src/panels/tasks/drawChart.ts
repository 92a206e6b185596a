// Draws the chart of moves, tasks and waits.

import type { Colour } from "../shared/canvas";
import type { ArmRest } from "../shared/cell";
import { awaitsArm, type Segment, type TaskSegments, visible } from "./chart";
import type { MoveTimes } from "./moves";
import { type Range, ticks } from "./range";

export const LANE = 22;
export const LABELS = 96;
const AXIS = 18;

export interface Chart {
  segments: TaskSegments;
  moves: readonly MoveTimes[];
  cut: ReadonlySet<number>;
  /** Time spans in which the arm is at rest, also during a move. */
  rests: readonly ArmRest[];
  range: Range;
  time: number;
}

export function chartHeight(tasks: number): number {
  return (tasks + 1) * LANE + AXIS;
}

export function draw(canvas: CanvasRenderingContext2D, width: number, { segments, moves, cut, rests, range, time }: Chart, colour: Colour): void {
  const names = segments.names();
  const height = chartHeight(names.length);
  const plot = width - LABELS;
  const x = (t: number): number => LABELS + ((t - range[0]) / Math.max(range[1] - range[0], 1e-9)) * plot;
  canvas.clearRect(0, 0, width, height);
  canvas.font = "12px system-ui, sans-serif";
  canvas.textBaseline = "middle";
  drawAxis(canvas, width, height, range, x, colour);
  drawMoves(canvas, { moves: moves.filter((move) => isVisible(move, range, time)), cut, x, time, colour });
  drawRests(canvas, { rests, range, time }, x, colour);
  names.forEach((name, lane) => {
    const top = (lane + 1) * LANE;
    drawLabel(canvas, name, top, colour);
    for (const segment of visible(segments.of(name), range[0], Math.min(range[1], time), x(Math.min(range[1], time)) - LABELS)) {
      drawSegment(canvas, segment, top, colour);
      if (awaitsArm(segment) && segment.end <= time && segment.w > 3) {
        drawLink(canvas, LABELS + segment.x + segment.w, top, colour);
      }
    }
  });
  drawLabel(canvas, "Arm", 0, colour);
  canvas.fillStyle = colour("--chart-cursor");
  canvas.fillRect(Math.round(x(time)) - 1, 0, 2, height - AXIS);
}

function isVisible({ started, done }: MoveTimes, [start, end]: Range, time: number): boolean {
  return started !== undefined && started <= Math.min(end, time) && (done ?? Infinity) >= start;
}

function drawAxis(canvas: CanvasRenderingContext2D, width: number, height: number, range: Range, x: (t: number) => number, colour: Colour): void {
  for (const t of ticks(range, Math.max(2, Math.floor((width - LABELS) / 80)))) {
    canvas.fillStyle = colour("--chart-grid");
    canvas.fillRect(Math.round(x(t)), 0, 1, height - AXIS + 4);
    canvas.fillStyle = colour("--text");
    canvas.textAlign = x(t) > width - 24 ? "right" : x(t) < LABELS + 12 ? "left" : "center";
    canvas.fillText(`${t} s`, x(t), height - AXIS / 2);
  }
  canvas.textAlign = "left";
}

/** Draws a label, which covers the area to the left of the plot. */
function drawLabel(canvas: CanvasRenderingContext2D, name: string, top: number, colour: Colour): void {
  canvas.fillStyle = colour("--panel");
  canvas.fillRect(0, top, LABELS, LANE);
  canvas.fillStyle = colour("--text");
  canvas.fillText(name, 4, top + LANE / 2, LABELS - 8);
}

interface MovesOfChart {
  moves: readonly MoveTimes[];
  cut: ReadonlySet<number>;
  x: (t: number) => number;
  time: number;
  colour: Colour;
}

/** Draws moves alternately in two shades; a triangle marks a move without its blend. */
function drawMoves(canvas: CanvasRenderingContext2D, { moves, cut, x, time, colour }: MovesOfChart): void {
  for (const { id, started = 0, blend, done = Infinity } of moves) {
    const [left, right] = [Math.max(LABELS, x(started)), x(Math.min(done, time))];
    canvas.fillStyle = colour(id % 2 === 0 ? "--chart-move" : "--chart-move-next");
    canvas.fillRect(left, 4, Math.max(1, right - left), LANE - 8);
    if (blend !== undefined && blend <= time) {
      canvas.fillStyle = colour("--chart-blend");
      canvas.fillRect(Math.max(LABELS, x(blend)), 4, Math.max(1, right - Math.max(LABELS, x(blend))), LANE - 8);
    }
    if (cut.has(id)) {
      canvas.fillStyle = colour("--chart-error");
      canvas.beginPath();
      canvas.moveTo(right - 5, 1);
      canvas.lineTo(right + 5, 1);
      canvas.lineTo(right, 10);
      canvas.fill();
    }
  }
}

/** Replaces the bar of a move by a thin bar, as for a wait, where the arm is at rest during the move. */
function drawRests(canvas: CanvasRenderingContext2D, { rests, range, time }: Pick<Chart, "rests" | "range" | "time">, x: (t: number) => number, colour: Colour): void {
  for (const { start, end } of rests) {
    const [left, right] = [Math.max(LABELS, x(start)), x(Math.min(end, time, range[1]))];
    if (right - left >= 1) {
      canvas.fillStyle = colour("--panel");
      canvas.fillRect(left, 4, right - left, LANE - 8);
      canvas.fillStyle = colour("--chart-waits");
      canvas.fillRect(left, 8, right - left, LANE - 16);
    }
  }
}

/**
 * Draws a segment: a full bar for computing, a thin bar for waiting, a bar of full height for an error, a dashed line
 * for suspension.
 */
function drawSegment(canvas: CanvasRenderingContext2D, segment: Segment & { x: number; w: number }, top: number, colour: Colour): void {
  const left = LABELS + segment.x;
  const [name, inset] = segment.state === "error" ? ["--chart-error", 1] as const
    : segment.state === "suspended" ? ["--chart-suspended", 9] as const
      : segment.waits === null ? ["--chart-running", 4] as const
        : awaitsArm(segment) ? ["--chart-waits-arm", 8] as const : ["--chart-waits", 8] as const;
  canvas.fillStyle = colour(name);
  canvas.fillRect(left, top + inset, Math.max(1, segment.w), LANE - 2 * inset);
}

/** Draws a line from the lane of the arm to the end of a wait for the arm. */
function drawLink(canvas: CanvasRenderingContext2D, x: number, top: number, colour: Colour): void {
  canvas.strokeStyle = colour("--chart-waits-arm");
  canvas.beginPath();
  canvas.setLineDash([2, 2]);
  canvas.moveTo(x, LANE - 4);
  canvas.lineTo(x, top + LANE / 2);
  canvas.stroke();
  canvas.setLineDash([]);
}
