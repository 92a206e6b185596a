// The poses of elements, requested for the rows that are on the screen.

import { signal } from "@preact/signals";
import type { Host } from "./host";
import { placeId } from "./place";
import type { DataPose } from "./protocol";

/** Milliseconds without scrolling before poses are requested. */
const PAUSE = 120;

export class Poses {
  /** By place. A new map when poses arrive. */
  readonly known = signal<ReadonlyMap<string, DataPose>>(new Map());
  private readonly requested = new Set<string>();
  private names: readonly string[] = [];
  private timer: ReturnType<typeof setTimeout> | undefined;
  /** Grows when the file changes; older answers are outdated. */
  private round = 0;

  constructor(private readonly host: () => Host | undefined, private readonly report: (fault: unknown) => void) {}

  /** The file has changed: poses depend on other data, so all are outdated. The old ones are shown until the new ones arrive. */
  forget(): void {
    this.round += 1;
    this.requested.clear();
    this.show(this.names);
  }

  /** Requests what is not known of these data, when the reader has stopped to scroll. */
  show(names: readonly string[]): void {
    this.names = names;
    clearTimeout(this.timer);
    this.timer = setTimeout(() => void this.load().catch(this.report), PAUSE);
  }

  private async load(): Promise<void> {
    const { round } = this;
    const names = this.names.filter((name) => !this.requested.has(name));
    const host = this.host();
    if (names.length === 0 || host === undefined) {
      return;
    }
    names.forEach((name) => this.requested.add(name));
    const poses = await host.request("poses", { names });
    if (round === this.round) {
      const wanted = new Set(names);
      const others = [...this.known.peek()].filter(([, { name }]) => !wanted.has(name));
      this.known.value = new Map([...others, ...poses.map((pose): [string, DataPose] => [placeId({ name: pose.name, key: pose.key }), pose])]);
    }
  }
}

export function worldText({ world }: DataPose): string {
  return world === null ? "" : world.map((part) => (Number(part.toFixed(1)) + 0).toFixed(1)).join("  ");
}

/** One word for the cell, and the sentences for its title. */
export function reachText({ reach }: DataPose): string {
  return reach === null ? "" : reach === "reachable" ? "reachable" : "out of reach";
}

export function poseTitle({ chain, why, joints }: DataPose): string {
  const at = joints === null ? "" : `Joints ${joints.map((joint) => String(Number(joint.toFixed(2)))).join(", ")}`;
  return [why ?? "", chain, at].filter((text) => text !== "").join("\n");
}
