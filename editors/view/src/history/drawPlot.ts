// Draws the lines, one lane for each unit.

import type { Colour } from "../panels/shared/canvas";
import type { Series } from "./messages";
import type { Range } from "../panels/tasks/range";
import { type Lane, type NumberRange, numberRange, numberTicks, unitSign } from "./lanes";
import type { PlotAxis } from "./plotModel";
import { columnsOf } from "./stepLine";
import type { Step } from "./steps";

/** Space for the labels of the numbers, in px. */
export const LABELS = 72;
/** Space for the labels of the times. */
const AXIS = 22;
/** Space above each lane for its unit. */
const TITLE = 18;
const RIGHT = 10;

/** Number of different colours and dashes. */
export const STYLES = 6;
/** Dashes of the lines, so that colours are not needed to distinguish them. */
export const DASHES: readonly (readonly number[])[] = [[], [], [], [7, 3], [7, 3], [2, 2]];

export interface Plot {
  width: number;
  height: number;
  lanes: readonly Lane[];
  series: readonly Series[];
  steps: readonly Step[];
  range: Range;
  axis: PlotAxis;
  /** Present time, at which the lines end; `undefined` if the axis is no time. */
  now: number | undefined;
  selected: Step | undefined;
  hovered: Step | undefined;
}

/** Returns the width of the lines' area. */
export function plotWidth(width: number): number {
  return Math.max(1, width - LABELS - RIGHT);
}

export function draw(canvas: CanvasRenderingContext2D, plot: Plot, colour: Colour): void {
  const { width, height, lanes, range } = plot;
  canvas.clearRect(0, 0, width, height);
  canvas.font = "12px system-ui, sans-serif";
  canvas.lineWidth = 1.5;
  const x = (t: number): number => LABELS + ((t - range[0]) / (range[1] - range[0])) * plotWidth(width);
  const bottom = height - AXIS;
  drawAxis(canvas, plot, x, colour);
  lanes.forEach((lane, index) => {
    const top = (bottom * index) / lanes.length + TITLE;
    drawLane(canvas, plot, lane, { top, bottom: (bottom * (index + 1)) / lanes.length - 6 }, colour);
  });
  for (const [t, name, lineWidth] of [[plot.hovered?.t, "--plot-text", 1], [plot.selected?.t, "--plot-selected", 2], [plot.now, "--plot-now", 2]] as const) {
    if (t !== undefined && t >= range[0] && t <= range[1]) {
      canvas.fillStyle = colour(name);
      canvas.fillRect(Math.round(x(t)) - lineWidth / 2, 0, lineWidth, bottom);
    }
  }
  drawPresent(canvas, plot, x, colour);
}

/** Writes a word at the line of the present. */
function drawPresent(canvas: CanvasRenderingContext2D, { now, range }: Plot, x: (t: number) => number, colour: Colour): void {
  if (now !== undefined && now >= range[0] && now <= range[1]) {
    canvas.fillStyle = colour("--plot-now");
    canvas.textAlign = x(now) > LABELS + 60 ? "right" : "left";
    canvas.fillText("present", x(now) + (canvas.textAlign === "right" ? -5 : 5), TITLE / 2);
  }
}

/** Draws the horizontal axis, and the time after the present. */
function drawAxis(canvas: CanvasRenderingContext2D, { width, height, range, axis, now }: Plot, x: (t: number) => number, colour: Colour): void {
  const bottom = height - AXIS;
  canvas.textBaseline = "middle";
  if (now !== undefined && now < range[1]) {
    const left = Math.max(LABELS, x(now));
    canvas.fillStyle = colour("--plot-later");
    canvas.fillRect(left, 0, width - RIGHT - left, bottom);
  }
  for (const { at: t, text } of axis.ticks(range, Math.max(2, Math.floor(plotWidth(width) / 90)))) {
    canvas.fillStyle = colour("--plot-grid");
    canvas.fillRect(Math.round(x(t)), 0, 1, bottom + 4);
    canvas.fillStyle = colour("--plot-text");
    canvas.textAlign = x(t) > width - 30 ? "right" : "center";
    canvas.fillText(text, Math.min(x(t), width - 2), height - AXIS / 2 + 2);
  }
}

interface LaneArea {
  top: number;
  bottom: number;
}

function drawLane(canvas: CanvasRenderingContext2D, plot: Plot, lane: Lane, { top, bottom }: LaneArea, colour: Colour): void {
  const { width, steps, range, series } = plot;
  const numbers = numberRange(lane, steps, range);
  const y = scale(numbers, top, bottom);
  canvas.textAlign = "right";
  for (const { at, text } of numberTicks(lane, numbers, Math.max(2, Math.floor((bottom - top) / 36)))) {
    canvas.fillStyle = colour("--plot-grid");
    canvas.fillRect(LABELS, Math.round(y(at)), plotWidth(width), 1);
    canvas.fillStyle = colour("--plot-text");
    canvas.fillText(text, LABELS - 6, y(at), LABELS - 8);
  }
  canvas.fillText(unitSign(lane.unit), LABELS - 6, top - TITLE / 2, LABELS - 8);
  for (const index of lane.series) {
    const style = series.length > 0 ? index % STYLES : 0;
    canvas.strokeStyle = colour(`--plot-${style + 1}`);
    canvas.setLineDash([...DASHES[style] ?? []]);
    drawLine(canvas, plot, index, y);
  }
  canvas.setLineDash([]);
  for (const step of [...separatePoints(plot), plot.hovered, plot.selected]) {
    drawMarks(canvas, plot, lane, step, y, colour);
  }
}

function scale([low, high]: NumberRange, top: number, bottom: number): (number: number) => number {
  return (number) => bottom - ((number - low) / (high - low)) * (bottom - top);
}

/** Returns the steps that are drawn as dots: values of an axis without steps, if they are far enough from each other. */
function separatePoints({ steps, range, axis, width }: Plot): readonly Step[] {
  const distance = plotWidth(width) / (range[1] - range[0]);
  return axis.isStepped || distance < 8 ? [] : steps.filter(({ t }) => t >= range[0] && t <= range[1]);
}

/** Draws a line until the present or the right edge. */
function drawLine(canvas: CanvasRenderingContext2D, { steps, range, axis, width, now = Infinity }: Plot, series: number, y: (number: number) => number): void {
  const inside = plotWidth(width);
  const end = Math.max(0, Math.min(inside, ((now - range[0]) / (range[1] - range[0])) * inside));
  canvas.beginPath();
  let last: number | undefined;
  for (const column of columnsOf(steps, series, [range[0], Math.min(range[1], now)], end)) {
    const x = LABELS + column.x;
    if (last !== undefined && axis.isStepped) {
      canvas.lineTo(x, y(last));
    }
    const { low = last, high = last } = column;
    if (low !== undefined && high !== undefined) {
      if (last === undefined) {
        canvas.moveTo(x, y(low));
      }
      canvas.lineTo(x, y(low));
      canvas.lineTo(x, y(high));
    }
    if (column.last !== undefined) {
      canvas.lineTo(x, y(column.last));
    }
    last = column.last;
  }
  if (last !== undefined && axis.isStepped) {
    canvas.lineTo(LABELS + end, y(last));
  }
  canvas.stroke();
}

/** Draws a dot at each number of a step. */
function drawMarks(canvas: CanvasRenderingContext2D, { range, width }: Plot, lane: Lane, step: Step | undefined, y: (number: number) => number, colour: Colour): void {
  if (step === undefined || step.t < range[0] || step.t > range[1]) {
    return;
  }
  const x = LABELS + ((step.t - range[0]) / (range[1] - range[0])) * plotWidth(width);
  for (const index of lane.series) {
    const number = step.numbers[index];
    if (number !== null && number !== undefined) {
      canvas.fillStyle = colour(`--plot-${(index % STYLES) + 1}`);
      canvas.beginPath();
      canvas.arc(x, y(number), 3.5, 0, 2 * Math.PI);
      canvas.fill();
    }
  }
}
