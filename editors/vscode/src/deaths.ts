// How often the server died of late: one that dies again and again is not started any more.

/** So many deaths within `PERIOD` milliseconds are no accident. */
export const TOO_MANY = 4;
export const PERIOD = 3 * 60 * 1000;

export class Deaths {
  private times: number[] = [];

  /** One more death, at a time in milliseconds. Says whether it is worth while to start the server again. */
  add(now: number): "again" | "enough" {
    this.times = [...this.times.filter((time) => now - time < PERIOD), now];
    return this.times.length < TOO_MANY ? "again" : "enough";
  }

  /** The user wants it anew. */
  forget(): void {
    this.times = [];
  }
}
