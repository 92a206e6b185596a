// Code of a program, with marks at lines. Only the visible lines are in the document.

import type { JSX, TargetedKeyboardEvent, TargetedPointerEvent } from "preact";
import { useEffect } from "preact/hooks";
import type { ProgramCode } from "../../wire";
import { Spacer } from "../shared/Spacer";
import { useVisibleRows } from "../shared/useVisibleRows";
import { type LineMarks, lineState } from "./marks";
import type { Program } from "./programs";

/** Height of a line in px, as in program.css. */
const LINE_HEIGHT = 20;

const COLUMNS = 4;

/** Number of characters that fit next to the names of tasks in a narrow panel. */
const SHORT_LINE = 24;

/** Keys that scroll a box. */
const SCROLL_KEYS: readonly string[] = ["ArrowUp", "ArrowDown", "PageUp", "PageDown", "Home", "End", " "];

/** Line that is scrolled into view. */
export interface RevealedLine {
  line: number;
  /** Whether the user has opened the line. */
  isMarked: boolean;
  /** Whether the line stays in view when the size of the box changes. */
  isFollowed: boolean;
  /** Changes with each request to scroll to the line. */
  request: unknown;
}

interface CodeTableProps {
  program: Program;
  marks: ReadonlyMap<number, LineMarks>;
  revealed: RevealedLine;
  /** Called when the user scrolls. */
  onScrolled: () => void;
}

export function CodeTable({ program, marks, revealed: { line: revealed, isMarked, isFollowed, request }, onScrolled }: CodeTableProps): JSX.Element {
  const { code, line: firstLine, name } = program;
  const { box, first, end, onScroll } = useVisibleRows(code.length, LINE_HEIGHT);
  useEffect(() => {
    const element = box.current;
    if (element === null) {
      return undefined;
    }
    const show = (): void => reveal(element, (revealed - firstLine) * LINE_HEIGHT);
    show();
    if (!isFollowed) {
      return undefined;
    }
    const observer = new ResizeObserver(show);
    observer.observe(element);
    return () => observer.disconnect();
  }, [box, program, revealed, firstLine, isFollowed, request]);
  useEffect(() => {
    // The button that has opened the line may be on a tab that is no longer shown.
    if (isMarked) {
      box.current?.focus({ preventScroll: true });
    }
  }, [box, isMarked, request]);
  const press = ({ key, target, currentTarget }: TargetedKeyboardEvent<HTMLDivElement>): void => {
    if (target === currentTarget && SCROLL_KEYS.includes(key)) {
      onScrolled();
    }
  };
  const grab = ({ target, currentTarget }: TargetedPointerEvent<HTMLDivElement>): void => {
    // Only the scroll bar belongs to the box itself; everything else is in the table.
    if (target === currentTarget && code.length * LINE_HEIGHT > currentTarget.clientHeight) {
      onScrolled();
    }
  };
  return (
    <div
      class="code-box" ref={box} tabIndex={0} role="region" aria-label={`Code of ${name}`}
      onScroll={onScroll} onWheel={onScrolled} onTouchMove={onScrolled} onKeyDown={press} onPointerDown={grab}
    >
      <table class="code-table" aria-label={`Code of ${name}`} aria-rowcount={code.length}>
        <tbody>
          <Spacer height={first * LINE_HEIGHT} columns={COLUMNS} />
          {code.slice(first, end).map((parts, index) => {
            const line = firstLine + first + index;
            return <CodeRow key={line} line={line} row={first + index + 1} parts={parts} marks={marks.get(line)} isOpened={isMarked && line === revealed} />;
          })}
          <Spacer height={(code.length - end) * LINE_HEIGHT} columns={COLUMNS} />
        </tbody>
      </table>
    </div>
  );
}

/** Scrolls if a line is outside of the box, so that it has a third of the box above it. */
function reveal(box: HTMLElement, top: number): void {
  const isVisible = top >= box.scrollTop + LINE_HEIGHT && top + 2 * LINE_HEIGHT <= box.scrollTop + box.clientHeight;
  if (!isVisible) {
    box.scrollTop = top - box.clientHeight / 3;
  }
}

interface CodeRowProps {
  line: number;
  /** Number of the row in the table, from 1. */
  row: number;
  parts: ProgramCode["code"][number];
  marks: LineMarks | undefined;
  isOpened: boolean;
}

function CodeRow({ line, row, parts, marks, isOpened }: CodeRowProps): JSX.Element {
  const { tasks = [], moving } = marks ?? {};
  const state = lineState(tasks);
  const classes = [state === undefined ? "" : `at ${state}`, moving === undefined ? "" : moving.isWaiting ? "moving rests" : "moving", isOpened ? "opened" : ""];
  return (
    <tr class={classes.join(" ").trim() || undefined} aria-rowindex={row} aria-current={isOpened ? "location" : state === undefined ? undefined : "step"}>
      <td class="marks" aria-hidden="true">
        <span class="arrow">{state === undefined ? "" : state === "error" ? "✕" : "▶"}</span>
        <span class="diamond">{moving === undefined ? "" : moving.isWaiting ? "◇" : "◆"}</span>
      </td>
      <th scope="row" class="line-number">{line}</th>
      <td class="code"><code>{parts.map(([kind, text], index) => (kind === "text" ? text : <span key={index} class={`code-${kind}`}>{text}</span>))}</code></td>
      <td class={parts.reduce((length, [, text]) => length + text.length, 0) > SHORT_LINE ? "names after-code" : "names"}>
        {tasks.map((task) => <span key={task.name} class={`name ${task.state}`} title={task.title}>{task.text}</span>)}
        {moving === undefined ? null : <span class="name arm" title={`${moving.instruction}: the arm ${moving.isWaiting ? "is at rest in this move" : "executes this move"}`}>{moving.isWaiting ? "arm waits" : "arm moves"}</span>}
      </td>
    </tr>
  );
}
