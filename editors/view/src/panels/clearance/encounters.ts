// Encounters: time spans in which two things of the cell are nearer to each other than their clearance.

import type * as wire from "../../wire";

/** Event `clearance` of a run. */
export interface ClearanceEvent {
  /** Time of the record, in s. */
  t: number;
  state: "near" | "contact" | "clear";
  a: string;
  b: string;
  /** Distance in mm, negative if the things overlap. A `clear` event contains the encounter's smallest distance. */
  distance: number;
  /** Nearest points of both things, in world. */
  points: readonly (readonly number[])[];
  /** Time at which the distance was measured, in s. */
  at: number;
  /** Instruction and line of the present move; absent while the arm is at rest. */
  type?: string;
  program?: string;
  line?: number;
}

export interface Encounter {
  a: string;
  b: string;
  /** Time from which the things are too near, in s. */
  start: number;
  /** Time from which they touch; `undefined` if they do not touch. */
  contact: number | undefined;
  /** Time from which they are apart again; `undefined` up to now. */
  end: number | undefined;
  /** Events in their order: near, contact, clear; the last one has the smallest distance. */
  events: ClearanceEvent[];
}

/** Returns the event as a clearance event; `undefined` for other kinds. */
export function clearanceOf(event: wire.RunEvent): ClearanceEvent | undefined {
  return event.kind === "clearance" ? (event as unknown as ClearanceEvent) : undefined;
}

/** Collects the encounters of a run from its events in their order. */
export class Encounters {
  readonly list: Encounter[] = [];
  private readonly open = new Map<string, Encounter>();

  clear(): void {
    this.list.length = 0;
    this.open.clear();
  }

  add(event: ClearanceEvent): void {
    const { a, b, state, at } = event;
    const pair = JSON.stringify([a, b]);
    const encounter = this.open.get(pair) ?? this.begin(pair, event);
    encounter.events.push(event);
    if (state === "contact") {
      encounter.contact ??= at;
    } else if (state === "clear") {
      encounter.end = event.t;
      this.open.delete(pair);
    }
  }

  private begin(pair: string, event: ClearanceEvent): Encounter {
    const { a, b, at } = event;
    const encounter: Encounter = { a, b, start: at, contact: undefined, end: undefined, events: [] };
    this.list.push(encounter);
    this.open.set(pair, encounter);
    return encounter;
  }
}

/** Returns the encounters at a time. */
export function encountersAt(encounters: readonly Encounter[], t: number): Encounter[] {
  return encounters.filter(({ start, end }) => start <= t && t <= (end ?? Infinity));
}

/** State of a thing: too near to another thing, or in contact with it. */
export type Nearness = "near" | "contact";

/** Returns the states of all things that are in one of these encounters at a time. */
export function nearnessAt(encounters: readonly Encounter[], t: number): ReadonlyMap<string, Nearness> {
  const states = new Map<string, Nearness>();
  for (const { a, b, contact } of encountersAt(encounters, t)) {
    const touches = contact !== undefined && contact <= t;
    for (const name of [a, b]) {
      if (touches || !states.has(name)) {
        states.set(name, touches ? "contact" : "near");
      }
    }
  }
  return states;
}

/** Returns the encounter's event that was measured nearest to a time. */
export function measuredNear({ events }: Encounter, t: number): ClearanceEvent | undefined {
  return events.toSorted((one, other) => Math.abs(one.at - t) - Math.abs(other.at - t))[0];
}

/** Returns each pair's event with the smallest distance up to a time, sorted by distance. */
export function smallestDistances(encounters: readonly Encounter[], t: number): ClearanceEvent[] {
  const smallest = new Map<string, ClearanceEvent>();
  for (const event of encounters.flatMap(({ events }) => events).filter(({ at }) => at <= t)) {
    const pair = JSON.stringify([event.a, event.b]);
    if (event.distance < (smallest.get(pair)?.distance ?? Infinity)) {
      smallest.set(pair, event);
    }
  }
  return [...smallest.values()].toSorted((one, other) => one.distance - other.distance);
}

/** Formats a distance, or the overlap depth if it is negative. */
export function distanceText(distance: number): string {
  return distance > 0 ? `${distance.toFixed(1)} mm` : distance < 0 ? `touches by ${(-distance).toFixed(1)} mm` : "touches";
}
