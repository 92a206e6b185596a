// History of the run, indexed for the panels.

import { clearanceOf, Encounters } from "../clearance/encounters";
import type { SignalState } from "../io/signalRows";
import type { Transfer } from "../io/lineBytes";
import { SignalHistory } from "../io/sparkline";
import { TaskSegments, type TaskState } from "../tasks/chart";
import type { RunEvent } from "../tasks/eventText";
import { type Fault, faultOf } from "../tasks/faults";
import { type MoveEvent, Moves } from "../tasks/moves";
import { RefusedMoves } from "../tasks/refusedMoves";
import type { TimedTasks } from "../tasks/times";

interface StatePart {
  t: number;
  tasks: readonly TaskState[];
}

interface MotionPart {
  queue: readonly { id: number; leaveDistance?: number | null }[];
}

interface IoPart {
  t: number;
  changes: readonly ({ link: string } & SignalState)[];
}

/** Grows with each message. After a restart or a step back, it is cleared and the messages are added again. */
export class PanelHistory {
  readonly signals = new SignalHistory();
  readonly segments = new TaskSegments();
  readonly moves = new Moves();
  readonly refused = new RefusedMoves();
  readonly encounters = new Encounters();
  readonly events: RunEvent[] = [];
  readonly faults: Fault[] = [];
  readonly transfers: Transfer[] = [];
  readonly states: TimedTasks[] = [];

  clear(): void {
    this.signals.clear();
    this.segments.clear();
    this.moves.clear();
    this.refused.clear();
    this.encounters.clear();
    this.events.length = 0;
    this.faults.length = 0;
    this.transfers.length = 0;
    this.states.length = 0;
  }

  addState({ t, tasks }: StatePart): void {
    this.states.push({ t, tasks });
    this.segments.add(t, tasks);
  }

  addMotion({ queue }: MotionPart): void {
    queue.forEach((move) => this.moves.addQueued(move));
  }

  addIo({ t, changes }: IoPart): void {
    changes.forEach(({ link, value }) => this.signals.add(link, t, value));
  }

  addEvents(events: readonly RunEvent[]): void {
    for (const event of events) {
      this.events.push(event);
      const [clearance, fault] = [clearanceOf(event), faultOf(event)];
      if (fault !== undefined) {
        this.faults.push(fault);
      } else if (clearance !== undefined) {
        this.encounters.add(clearance);
      } else if (event.kind === "move") {
        this.moves.add(event as unknown as MoveEvent);
        this.refused.add(event as unknown as MoveEvent);
      } else if (event.kind === "sio") {
        this.transfers.push(event as unknown as Transfer);
      }
    }
  }
}
