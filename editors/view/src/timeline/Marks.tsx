// Marks of moves, messages, distances and errors along the time.

import type { JSX } from "preact";
import { useEffect, useRef } from "preact/hooks";
import { isDark } from "../look";
import { type Group, groupOf } from "../panels/tasks/eventText";
import { countUpTo } from "../panels/tasks/upTo";
import type { Store } from "../store";
import type { TimeZoom } from "./zoom";

/** Rows of marks from the top, with their colours in the light and in the dark look. */
const KINDS: readonly (readonly [Group, string, string])[] = [["moves", "#0072b2", "#56b4e9"], ["messages", "#57616c", "#a6b0bc"], ["clearance", "#b36a00", "#ffb84d"], ["errors", "#c03a00", "#ff8a4c"]];
const ROW = 4;
const HEIGHT = KINDS.length * ROW;

export function Marks({ store, zoom }: { store: Store; zoom: TimeZoom }): JSX.Element {
  const canvas = useRef<HTMLCanvasElement>(null);
  // The entire time is updated a few times per second.
  const [start, end] = zoom.isZoomed.value ? zoom.range.value : store.panels.cell.whole.value;
  const dark = isDark.value;
  useEffect(() => {
    if (canvas.current !== null) {
      draw(canvas.current, store, [start, end], dark);
    }
  }, [store, start, end, dark]);
  return <canvas class="marks" ref={canvas} height={HEIGHT} aria-hidden="true" />;
}

function draw(canvas: HTMLCanvasElement, store: Store, [start, end]: readonly [number, number], dark: boolean): void {
  const width = canvas.clientWidth;
  canvas.width = width;
  const brush = canvas.getContext("2d");
  // One mark per pixel, even for many events.
  const drawn = new Set<number>();
  const { events } = store.panels.cell.history;
  for (const event of events.slice(countUpTo(events, start - 1e-9), countUpTo(events, end))) {
    const group = groupOf(event);
    const row = KINDS.findIndex(([kind]) => kind === group);
    const x = Math.round(((event.t - start) / (end - start)) * (width - 2));
    const place = x * KINDS.length + row;
    if (brush !== null && row >= 0 && !drawn.has(place)) {
      drawn.add(place);
      brush.fillStyle = KINDS[row]?.[dark ? 2 : 1] ?? "";
      brush.fillRect(x, row * ROW, 2, group === "errors" ? ROW : ROW - 1);
    }
  }
}
