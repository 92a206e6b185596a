// Texts of the confirmation of a push. Pure functions.

import type { PlannedChange } from "./answers";
import { counted } from "./items";
import type { Project } from "./projects";

export interface Confirmation {
  message: string;
  detail: string;
  /** Applications that the push changes. */
  applications: string[];
}

/** Largest number of listed files. The output channel contains all. */
const LISTED = 20;

const VERBS: Record<PlannedChange["action"], string> = { create: "add", replace: "replace", remove: "remove" };

/** Returns the texts for these changes. `notes` are lines of `val3` for the user. */
export function confirmation({ address, serial }: Project, changes: readonly PlannedChange[], notes: readonly string[]): Confirmation {
  const applications = applicationsOf(changes);
  const lines = changes.slice(0, LISTED).map(lineOf);
  const more = changes.length > LISTED ? [`and ${changes.length - LISTED} more`] : [];
  const list = [...lines, ...more, ...notes].join("\n");
  return {
    message: `Push ${counted(changes.length)} to the controller${serial === "" ? "" : ` ${serial}`} at ${address}?`,
    detail: applications.length === 0 ? list : `${list}\n\n${question(applications)}`,
    applications,
  };
}

function question(applications: readonly string[]): string {
  const subject = applications.length === 1 ? "Is the application" : "Are the applications";
  return `${subject} ${applications.join(", ")} stopped and unloaded on the controller? A controller may reject files of a loaded `
    + "application, or run old and new programs together. If you are not sure, the log of the controller decides: nothing is pushed "
    + "if an application runs, or if the log does not state whether one does.";
}

function lineOf({ path, action, size }: PlannedChange): string {
  const name = path.replace(/^usr\/usrapp\//, "");
  return size === null ? `${VERBS[action]} ${name}` : `${VERBS[action]} ${name} (${bytes(size)})`;
}

/** Formats a size like `val3`. */
function bytes(size: number): string {
  return size < 10_000 ? `${size} bytes` : `${Math.floor(size / 1000)} kB`;
}

/** Returns the applications with a change, sorted by name. */
function applicationsOf(changes: readonly PlannedChange[]): string[] {
  const names = changes.flatMap(({ path }) => /^usr\/usrapp\/([^/]+)\//.exec(path)?.[1] ?? []);
  return [...new Set(names)].sort();
}
