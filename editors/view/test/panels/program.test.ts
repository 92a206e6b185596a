import assert from "node:assert/strict";
import { test } from "node:test";
import { signal } from "@preact/signals";
import { lineState, marksOf, type MovingLine } from "../../src/panels/program/marks";
import { groupsOf, keyOf, type Program, programOf, programsOf } from "../../src/panels/program/programs";
import { followedLine, ProgramView } from "../../src/panels/program/ProgramView";
import type { TaskState } from "../../src/panels/tasks/chart";
import type { ProgramsMessage } from "../../src/wire";

const CELL: ProgramsMessage = {
  t: 0,
  application: "cell",
  programs: ["stop", "start"].map((name) => ({ name, file: `/cell/${name}.pgx`, line: 7, code: [[["keyword", "begin"]], [["text", "  delay("], ["number", "1"], ["text", ")"]], [["keyword", "end"]]] })),
};
const LIBRARY: ProgramsMessage = { t: 0, application: "part", programs: [{ name: "start", file: "/part/start.pgx", line: 3, code: [] }, { name: "grip", file: "/part/grip.pgx", line: 3, code: [] }] };

function task(name: string, program: string, line: number, more: Partial<TaskState> = {}): TaskState {
  return { name, state: "running", program, line, file: `/cell/${program}.pgx`, priority: 10, period: null, overruns: 0, waits: null, error: null, ...more };
}

function view(): ProgramView {
  const made = new ProgramView(signal(1));
  made.add(LIBRARY);
  made.add(CELL);
  return made;
}

const start = (): Program => {
  const found = view().programOf({ program: "start", line: 8, file: "/cell/start.pgx" });
  assert.ok(found);
  return found;
};

test("a program is found by its file, or by its name if it is unique", () => {
  const list = programsOf([CELL, LIBRARY], 2);
  assert.equal(programOf(list, { program: "start", line: 1, file: "/part/start.pgx" })?.application, "part");
  assert.equal(programOf(list, { program: "grip", line: 1 })?.file, "/part/grip.pgx");
  assert.equal(programOf(list, { program: "start", line: 1 }), undefined);
  assert.equal(programOf(list, { program: "start", line: 1, file: "/other/start.pgx" }), undefined);
});

test("a program that is loaded again has its earlier code in the past", () => {
  const time = signal(0);
  const shown = new ProgramView(time);
  shown.add(CELL);
  shown.add({ t: 5, application: "cell", programs: [{ name: "stop", file: "/cell/stop.pgx", line: 9, code: [] }] });
  shown.add({ ...LIBRARY, t: 6 });
  const lineAt = (t: number): unknown => {
    time.value = t;
    return shown.programs.value.get(keyOf({ program: "stop", file: "/cell/stop.pgx" }))?.line;
  };
  assert.deepEqual([0, 4.9, 5, 7].map(lineAt), [7, 7, 9, 9]);
  const list = shown.programs.value;
  assert.equal((lineAt(8), shown.programs.value), list, "the list is the same while no program changes");
  lineAt(1);
  assert.equal(shown.programs.value.size, 4, "programs of libraries that are loaded later are listed too");
});

test("the programs of the application come first, sorted by name", () => {
  const groups = groupsOf(view().programs.value, "cell").map(({ application, programs }) => [application, programs.map(({ name }) => name)]);
  assert.deepEqual(groups, [["cell", ["start", "stop"]], ["part", ["grip", "start"]]]);
});

test("marks are at the lines of their program", () => {
  const moving: MovingLine = { program: "start", line: 8, file: "/cell/start.pgx", instruction: "movej", isWaiting: false };
  const tasks = [task("a", "start", 8), task("b", "start", 8, { state: "error", error: 60 }), task("c", "start", 9, { state: "waiting", waits: "the arm (`waitEndMove`)" }), task("d", "stop", 8)];
  const marks = marksOf(start(), tasks, moving);
  assert.deepEqual([...marks.keys()], [8, 9]);
  const { tasks: first = [], moving: here } = marks.get(8) ?? {};
  assert.deepEqual(first.map(({ text }) => text), ["a", "b: error 60"]);
  assert.deepEqual([lineState(first), here], ["error", moving]);
  assert.deepEqual(marks.get(9)?.tasks.map(({ text, title }) => [text, title]), [["c waits", "c waits for the arm (waitEndMove)"]]);
  assert.equal(marksOf(start(), [], { ...moving, file: "/part/start.pgx" }).size, 0);
});

test("the tab follows a task, otherwise the one with the highest priority, or the arm", () => {
  const tasks = [task("a", "start", 8), task("b", "stop", 9)];
  const moving = { program: "stop", line: 8, file: "/cell/stop.pgx" };
  assert.equal(followedLine({ task: undefined }, tasks, moving)?.line, 8);
  assert.equal(followedLine({ task: "b" }, tasks, moving)?.line, 9);
  assert.equal(followedLine({ task: "ended" }, tasks, moving)?.line, 8);
  assert.equal(followedLine({ task: undefined }, [task("sync", "start", 1, { priority: null }), ...tasks, task("c", "stop", 10, { priority: 50 })], moving)?.line, 10);
  assert.equal(followedLine("arm", tasks, moving), moving);
  assert.equal(followedLine("arm", tasks, undefined), undefined);
});

test("a shown line ends following until the user follows again", () => {
  const shown = view();
  shown.follow({ task: "b" });
  shown.showLine({ program: "grip", line: 5 });
  assert.deepEqual(shown.chosen.value, { program: "grip", file: "/part/grip.pgx", line: 5, isMarked: true });
  shown.showLine({ program: "start", line: 5 });
  assert.equal(shown.chosen.value.program, "grip", "the name is ambiguous");
  shown.follow();
  assert.deepEqual([shown.chosen.value, shown.followed.value], [undefined, { task: "b" }]);
});
