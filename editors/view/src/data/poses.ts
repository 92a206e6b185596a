// Poses of elements, requested for the visible rows.

import { signal } from "@preact/signals";
import type { Host } from "./host";
import { placeId } from "./place";
import type { DataPose } from "./protocol";

/** Milliseconds without scrolling before poses are requested. */
const PAUSE = 120;

export class Poses {
  /** Poses by data path; a new map after each response. */
  readonly known = signal<ReadonlyMap<string, DataPose>>(new Map());
  private readonly requested = new Set<string>();
  private names: readonly string[] = [];
  private timer: ReturnType<typeof setTimeout> | undefined;
  /** Revision of the file; responses for earlier revisions are ignored. */
  private round = 0;

  constructor(private readonly host: () => Host | undefined, private readonly report: (fault: unknown) => void) {}

  /**
   * Invalidates all poses after a change of the file, because they depend on other data. The stale poses remain visible
   * until the new ones arrive.
   */
  forget(): void {
    this.round += 1;
    this.requested.clear();
    this.show(this.names);
  }

  /** Requests the missing poses of these data when scrolling has stopped. */
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

/** Returns the text of the cell; the title contains the details. */
export function reachText({ reach }: DataPose): string {
  return reach === null ? "" : { reachable: "reachable", outOfReach: "out of reach", noArm: "no arm" }[reach];
}

export function poseTitle({ chain, why, joints }: DataPose): string {
  const at = joints === null ? "" : `Joints ${joints.map((joint) => String(Number(joint.toFixed(2)))).join(", ")}`;
  return [why ?? "", chain, at].filter((text) => text !== "").join("\n");
}
