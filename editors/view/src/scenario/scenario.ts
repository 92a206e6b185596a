// Names and responses of the command `record`.

import type { Recorded } from "../wire";
import type { Answer } from "../panels/shared/cell";

/** Scenario that the server has written. */
export type Scenario = Recorded;

const NAME = /^[A-Za-z0-9_-]{1,64}$/;

/** Returns the reason why a scenario cannot have this name. */
export function nameFault(name: string): string | undefined {
  return NAME.test(name) ? undefined : "The name has 1 to 64 letters, digits, `_` and `-`.";
}

export function scenarioFrom(answer: Answer): Scenario {
  const remarks = answer["remarks"];
  return {
    file: textOf(answer["file"]),
    text: textOf(answer["text"]),
    remarks: Array.isArray(remarks) ? remarks.map(textOf) : [],
  };
}

function textOf(value: unknown): string {
  return typeof value === "string" ? value : "";
}
