// Plot of the values, operated with the mouse and the keyboard.

import type { JSX, RefObject, TargetedKeyboardEvent, TargetedPointerEvent, TargetedWheelEvent } from "preact";
import { useEffect, useRef, useState } from "preact/hooks";
import { paintCanvas } from "../panels/shared/canvas";
import type { Range } from "../panels/tasks/range";
import { draw, LABELS, type Plot, plotWidth } from "./drawPlot";
import type { PlotModel } from "./plotModel";
import { themes } from "./theme";

interface Size {
  width: number;
  height: number;
}

export function PlotView({ model }: { model: PlotModel }): JSX.Element {
  const box = useRef<HTMLDivElement>(null);
  const canvas = useRef<HTMLCanvasElement>(null);
  const [size, setSize] = useState<Size>({ width: 400, height: 240 });
  const [pointer, setPointer] = useState<{ x: number; y: number } | undefined>(undefined);
  const drag = useRef<{ x: number; range: Range; isMoved: boolean } | undefined>(undefined);
  const { steps, range, selected, help, axis } = model;
  const shownSteps = steps.value;
  const timeAt = (x: number): number => range.value[0] + ((x - LABELS) / plotWidth(size.width)) * (range.value[1] - range.value[0]);
  const now = model.present.value;
  const end = now ?? Infinity;
  const hovered = pointer === undefined || pointer.x < LABELS || timeAt(pointer.x) > end ? undefined : shownSteps[model.indexAt(timeAt(pointer.x))];
  const chosen = shownSteps[selected.value];
  const plot: Plot = { ...size, lanes: model.lanes.value, series: model.series.value, steps: shownSteps, range: range.value, axis, now, selected: chosen, hovered };
  // The colours of the canvas are those of the editor's theme.
  themes.valueOf();
  useSize(box, setSize);
  useEffect(() => paintCanvas(canvas.current, size.width, size.height, (context, colour) => draw(context, plot, colour)));
  const move = (event: TargetedPointerEvent<HTMLElement>): void => {
    const { current } = drag;
    if (current === undefined || event.buttons === 0) {
      drag.current = undefined;
      setPointer({ x: event.offsetX, y: event.offsetY });
    } else if (current.isMoved || Math.abs(event.clientX - current.x) > 3) {
      current.isMoved = true;
      model.shift((current.x - event.clientX) / plotWidth(size.width), current.range);
    }
  };
  const up = (event: TargetedPointerEvent<HTMLElement>): void => {
    if (drag.current?.isMoved === false) {
      model.select(model.indexAt(Math.min(end, timeAt(event.offsetX))));
    }
    drag.current = undefined;
  };
  const wheel = (event: TargetedWheelEvent<HTMLElement>): void => {
    if (event.ctrlKey || event.shiftKey) {
      event.preventDefault();
      model.zoom(event.deltaY + event.deltaX > 0 ? 1.25 : 0.8, timeAt(event.offsetX));
    }
  };
  const name = model.name.value;
  return (
    <div
      class="plot" ref={box} role="slider" tabIndex={0} aria-label={`Plot of ${name}`} title={pointer === undefined ? help : undefined}
      aria-valuemin={0} aria-valuemax={Math.max(0, shownSteps.length - 1)} aria-valuenow={Math.max(0, selected.value)}
      aria-valuetext={chosen === undefined ? "no value" : model.describe(chosen, true)}
      onKeyDown={(event) => press(event, model)} onPointerMove={move} onPointerUp={up} onWheel={wheel}
      onPointerLeave={() => { drag.current = undefined; setPointer(undefined); }}
      onPointerDown={(event) => { drag.current = { x: event.clientX, range: range.value, isMoved: false }; }}
    >
      <canvas ref={canvas} aria-hidden="true" />
      {hovered === undefined || pointer === undefined ? null : (
        <div class="hint" aria-hidden="true" style={hintPlace(pointer, size)}>
          <strong>{hovered.value}</strong>
          <span>{model.describe(hovered, false)}</span>
        </div>
      )}
    </div>
  );
}

/** Places the hint next to the pointer, on the side with more space. */
function hintPlace({ x, y }: { x: number; y: number }, { width, height }: Size): Record<string, string> {
  return {
    ...(x < width / 2 ? { left: `${x + 14}px` } : { right: `${width - x + 14}px` }),
    ...(y < height / 2 ? { top: `${y + 6}px` } : { bottom: `${height - y + 6}px` }),
  };
}

function press(event: TargetedKeyboardEvent<HTMLElement>, model: PlotModel): void {
  const [index, last] = [model.selected.peek(), model.steps.peek().length - 1];
  const around = model.steps.peek()[index]?.t ?? 0;
  const actions: Record<string, () => void> = {
    ArrowLeft: () => model.select(Math.max(0, index - 1)),
    ArrowRight: () => model.select(Math.min(last, index + 1)),
    ArrowDown: () => model.select(Math.max(0, index - 1)),
    ArrowUp: () => model.select(Math.min(last, index + 1)),
    PageDown: () => model.select(Math.max(0, index - 10)),
    PageUp: () => model.select(Math.min(last, index + 10)),
    Home: () => model.select(0),
    End: () => model.select(last),
    Enter: () => model.open(index, true),
    "+": () => model.zoom(0.5, around),
    "-": () => model.zoom(2, around),
    "0": () => model.showAll(),
  };
  const action = event.ctrlKey || event.metaKey || event.altKey ? undefined : actions[event.key];
  if (action !== undefined) {
    event.preventDefault();
    action();
  }
}

function useSize(box: RefObject<HTMLDivElement | null>, setSize: (size: Size) => void): void {
  useEffect(() => {
    const element = box.current;
    if (element === null) {
      return undefined;
    }
    const observer = new ResizeObserver(() => setSize({ width: Math.max(160, element.clientWidth), height: Math.max(80, element.clientHeight) }));
    observer.observe(element);
    return () => observer.disconnect();
  }, [box, setSize]);
}
