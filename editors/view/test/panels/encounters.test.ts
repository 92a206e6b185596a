import assert from "node:assert/strict";
import { test } from "node:test";
import { type ClearanceEvent, distanceText, Encounters, encountersAt, measuredNear, nearnessAt, smallestDistances } from "../../src/panels/clearance/encounters";
import { groupOf, textOf } from "../../src/panels/tasks/eventText";

function event(t: number, state: ClearanceEvent["state"], a: string, distance: number, at = t): ClearanceEvent {
  return { t, state, a, b: "fence", distance, points: [[0, 0, 0], [distance, 0, 0]], at, type: "movel", program: "place", line: 31 };
}

function encounters(): Encounters {
  const all = new Encounters();
  [
    event(1, "near", "gripper", 20), event(1.5, "contact", "gripper", 0), event(1.6, "near", "link4", 99), event(2, "clear", "gripper", -3.4, 1.7),
    event(2.4, "clear", "link4", 12.1, 2.1), event(3, "near", "gripper", 19), event(3.5, "clear", "gripper", 15, 3.2), event(4, "near", "link4", 99),
  ].forEach((each) => all.add(each));
  return all;
}

test("an encounter ends when its things are apart again", () => {
  const { list } = encounters();
  assert.deepEqual(list.map(({ a, start, contact, end, events }) => [a, start, contact, end, events.at(-1)?.distance]), [
    ["gripper", 1, 1.5, 2, -3.4], ["link4", 1.6, undefined, 2.4, 12.1], ["gripper", 3, undefined, 3.5, 15], ["link4", 4, undefined, undefined, 99],
  ]);
  assert.deepEqual([0.9, 1.2, 1.8, 2.2, 2.7, 9].map((t) => encountersAt(list, t).map(({ a }) => a)), [[], ["gripper"], ["gripper", "link4"], ["link4"], [], ["link4"]]);
});

test("a contact counts more than a near thing", () => {
  const { list } = encounters();
  assert.deepEqual([...nearnessAt(list, 1.2)], [["gripper", "near"], ["fence", "near"]]);
  assert.deepEqual([...nearnessAt(list, 1.7)], [["gripper", "contact"], ["fence", "contact"], ["link4", "near"]]);
});

test("each pair has its smallest distance up to the shown time", () => {
  const { list } = encounters();
  const rows = (t: number): unknown[] => smallestDistances(list, t).map(({ a, distance }) => [a, distance]);
  assert.deepEqual([rows(0.5), rows(1.2), rows(1.65), rows(9)], [[], [["gripper", 20]], [["gripper", 0], ["link4", 99]], [["gripper", -3.4], ["link4", 12.1]]]);
});

test("the distance measured nearest to a time is shown", () => {
  const [first] = encounters().list;
  assert.ok(first);
  assert.deepEqual([0, 1.4, 1.65, 9].map((t) => measuredNear(first, t)?.distance), [20, 0, -3.4, -3.4]);
});

test("a distance of 0 or less is a contact", () => {
  assert.deepEqual([12.14, 0, -3.44].map(distanceText), ["12.1 mm", "touches", "touches by 3.4 mm"]);
});

test("the log names both things", () => {
  const [near, contact, clear] = [event(1, "near", "gripper", 20), event(1, "contact", "gripper", -3.4), event(1, "clear", "gripper", 12)].map((each) => ({ ...each, kind: "clearance" }));
  assert.ok(near && contact && clear);
  assert.deepEqual([near, contact, clear].map(textOf), [
    "gripper is 20.0 mm from fence", "gripper touches fence by 3.4 mm", "gripper is apart from fence: the smallest distance was 12.0 mm",
  ]);
  assert.deepEqual([near, contact, clear].map(groupOf), ["clearance", "errors", "clearance"]);
});
