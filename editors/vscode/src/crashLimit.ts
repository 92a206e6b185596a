// Counts recent crashes of the server. A server that crashes repeatedly is not restarted.

/** Number of crashes within `PERIOD` milliseconds from which on the server is not restarted. */
export const TOO_MANY = 4;
export const PERIOD = 3 * 60 * 1000;

export class CrashLimit {
  private times: number[] = [];

  /** Adds a crash, at a time in milliseconds. Returns whether the server may be restarted. */
  add(now: number): "again" | "enough" {
    this.times = [...this.times.filter((time) => now - time < PERIOD), now];
    return this.times.length < TOO_MANY ? "again" : "enough";
  }

  /** Resets the count after a restart by the user. */
  reset(): void {
    this.times = [];
  }
}
