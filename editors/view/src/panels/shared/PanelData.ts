// Messages of a run, indexed for the panels.

import type { SignalState } from "../io/signalRows";
import { DataValues } from "../points/pointsAt";
import type { CellPoint, CellScene, JointValue } from "./cell";
import { PanelHistory } from "./history";
import type { DataMessage, EventsMessage, IoMessage, MotionMessage, PageMessage, PartsMessage, ReachMessage, StateMessage } from "./messages";
import { TimedLevels } from "./timed";

/** Kinds of messages that the panels index. */
export type IndexedMessage =
  | ({ kind: "state" } & StateMessage) | ({ kind: "motion" } & MotionMessage) | ({ kind: "io" } & IoMessage) | ({ kind: "page" } & PageMessage)
  | ({ kind: "events" } & EventsMessage) | ({ kind: "parts" } & PartsMessage) | ({ kind: "data" } & DataMessage) | ({ kind: "reach" } & ReachMessage);

/** Grows with each message. */
export class PanelData {
  readonly past = new PanelHistory();
  readonly states: StateMessage[] = [];
  readonly motions: MotionMessage[] = [];
  readonly pages: PageMessage[] = [];
  readonly placed: PartsMessage[] = [];
  readonly reaches: ReachMessage[] = [];
  readonly levels = new TimedLevels<SignalState>();
  readonly points = new DataValues<CellPoint>(({ points }) => points);
  readonly joints = new DataValues<JointValue>(({ joints }) => joints ?? []);
  readonly frames = new DataValues<CellPoint>(({ frames }) => frames ?? []);
  readonly tools = new DataValues<CellPoint>(({ tools }) => tools ?? []);

  constructor(scene: CellScene | undefined) {
    this.points.restart(scene?.points ?? []);
    this.joints.restart(scene?.joints ?? []);
    this.frames.restart(scene?.frames ?? []);
    this.tools.restart(scene?.tools ?? []);
  }

  add(message: IndexedMessage): void {
    switch (message.kind) {
      case "state":
        this.states.push(message);
        this.past.addState(message);
        break;
      case "motion":
        this.motions.push(message);
        this.past.addMotion(message);
        break;
      case "io":
        this.past.addIo(message);
        message.changes.forEach((change) => this.levels.add(message.t, change.link, change));
        break;
      case "page": this.pages.push(message); break;
      case "events": this.past.addEvents(message.events); break;
      case "parts": this.placed.push(message); break;
      case "data": [this.points, this.joints, this.frames, this.tools].forEach((values) => values.add(message)); break;
      case "reach": this.reaches.push(message); break;
    }
  }
}
