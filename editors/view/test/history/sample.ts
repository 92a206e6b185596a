// Invented histories and arrays.

import type { ArrayTable, History, Series, Write } from "../../src/history/messages";

const AXES: readonly Series[] = ["j1", "j2", "j3", "j4", "j5", "j6"].map((name) => ({ name, unit: "degrees", isDigital: false }));
const POSE: readonly Series[] = ["x", "y", "z", "rx", "ry", "rz"].map((name, index) => ({ name, unit: index < 3 ? "mm" : "degrees", isDigital: false }));
export const NUMBER: readonly Series[] = [{ name: "", unit: null, isDigital: false }];
export const DIGITAL: readonly Series[] = [{ name: "", unit: null, isDigital: true }];

/** Returns a write of a line, or from outside. */
export function write(t: number, numbers: readonly (number | null)[], more: Partial<Write> = {}): Write {
  const value = numbers.length === 1 ? String(numbers[0]) : `{${numbers.join(",")}}`;
  return { t, value, numbers, task: "main~", source: { application: "main", program: "start", line: 7, file: "/cell/start.pgx" }, ...more };
}

/** Returns a history with these writes, the oldest first. */
export function history(type: string, series: readonly Series[], writes: readonly Write[], more: Partial<History> = {}): History {
  const numbers = series.map(() => 0);
  return {
    name: "main:nCount", type, series, now: 10, writes: writes.toReversed(), more: false,
    initial: numbers.length === 0 ? "\"\"" : numbers.length === 1 ? "0" : `{${numbers.join(",")}}`, initialNumbers: numbers, since: 0, ...more,
  };
}

/** Returns a count that increases, and falls back after each 16 steps. */
export function counts(count: number): History {
  const writes = Array.from({ length: count }, (_, index) => write((index + 1) * (9 / count), [index % 16], { source: { application: "main", program: index % 16 === 0 ? "reset" : "start", line: 7 + (index % 3), file: "/cell/start.pgx" } }));
  return history("num", NUMBER, writes);
}

export function joints(): History {
  const writes = Array.from({ length: 24 }, (_, index) => write(0.4 * index + 0.2, AXES.map((_, axis) => Math.round(900 * Math.sin(index / 4 + axis)) / 10)));
  return history("joint", AXES, writes, { name: "main:jHere", now: 9.6 });
}

export function points(): History {
  const writes = Array.from({ length: 12 }, (_, index) => write(index * 0.7 + 0.3, [400 + index * 20, -300 + index * 5, 250 - index, 180, index * 2, 90]));
  return history("point", POSE, writes, { name: "main:pPlace", now: 9 });
}

export function inputs(): History {
  const outside = { task: null, source: null };
  return history("dio", DIGITAL, [1, 2.5, 2.6, 7].map((t, index) => write(t, [1 - (index % 2)], { ...outside, value: String(index % 2 === 0) })), { name: "io:BasicIO-1\\%I4", initial: "false" });
}

export function texts(): History {
  return history("string", [], ["<img src=x onerror=alert(1)>", "bolt"].map((value, index) => write(index + 1, [], { value: JSON.stringify(value) })), { name: "main:sName", initialNumbers: [] });
}

/** Returns an array of joints; `count` is the number of elements beyond the shown ones. */
export function jointTable(shown: number, hidden = 0): ArrayTable {
  const rows = Array.from({ length: shown }, (_, index) => {
    const numbers = AXES.map((_, axis) => index * 10 + axis / 3);
    return { index: `[${index}]`, value: `{${numbers.join(", ")}}`, numbers };
  });
  return { name: "main:jMany", type: `joint[${shown + hidden}]`, series: AXES, now: 9.6, count: shown + hidden, rows };
}

export function textTable(): ArrayTable {
  const rows = [{ index: "[\"left\"]", value: "\"<img src=x onerror=alert(1)>\"", numbers: [] }];
  return { name: "main:sParts", type: "string[\"\"]", series: [], now: 0, count: 1, rows };
}
