// Counts recent deaths of the server: one that dies repeatedly is not restarted.

/** The number of deaths within `PERIOD` milliseconds after which the server is not restarted. */
export const TOO_MANY = 4;
export const PERIOD = 3 * 60 * 1000;

export class Deaths {
  private times: number[] = [];

  /** Adds a death, at a time in milliseconds. Returns whether the server may be restarted. */
  add(now: number): "again" | "enough" {
    this.times = [...this.times.filter((time) => now - time < PERIOD), now];
    return this.times.length < TOO_MANY ? "again" : "enough";
  }

  /** The user has restarted the server. */
  forget(): void {
    this.times = [];
  }
}
