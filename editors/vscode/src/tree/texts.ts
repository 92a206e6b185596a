// Texts of the view: descriptions, tooltips, and labels for screen readers.

import type { ProjectKind, TreeData, TreeProgram, TreeProject, TreeReference } from "../serverRequests";

export interface Texts {
  description: string;
  tooltip: string;
  spoken: string;
}

/** Largest number of shown characters of a value. */
const LONGEST_VALUE = 60;

const KINDS: Record<ProjectKind, string> = { application: "application", tests: "tests", library: "library", type: "user type" };

const access = (isPublic: boolean): string => (isPublic ? "public" : "private");

export function projectTexts({ name, kind }: TreeProject, folder: string): Texts {
  return { description: folder, tooltip: `${KINDS[kind]} ${name}\n${folder}`, spoken: `${name}, ${KINDS[kind]}, ${folder}` };
}

export function programTexts({ name, detail, public: isPublic }: TreeProgram): Texts {
  const signature = detail.replace(/^public /, "");
  const what = `${access(isPublic)} program`;
  return { description: detail, tooltip: `${what} ${name}${signature}`, spoken: `${name}, ${what}, ${signature}` };
}

export function dataTexts({ name, detail, public: isPublic, type, value }: TreeData): Texts {
  const shape = detail.replace(/^public /, "");
  const shown = value === null ? "" : type === "string" ? `"${value}"` : value;
  const assigned = (text: string): string => (text === "" ? "" : ` = ${text}`);
  return {
    description: detail + assigned(shortened(shown)),
    tooltip: `${access(isPublic)} ${type} ${name}${shape.slice(type.length)}${assigned(shown)}`,
    spoken: `${name}, ${access(isPublic)} ${shape}${shown === "" ? "" : `, ${shown}`}`,
  };
}

export function referenceTexts({ name, detail }: TreeReference, kind: "library" | "type"): Texts {
  return { description: detail, tooltip: `${KINDS[kind]} ${name}\n${detail}`, spoken: `${name}, ${KINDS[kind]}, ${detail}` };
}

export function missingTexts(entry: TreeReference, kind: "library" | "type"): Texts {
  const { description, tooltip, spoken } = referenceTexts(entry, kind);
  const fault = "there is no project at this path";
  return { description, tooltip: `${tooltip}\n${fault}`, spoken: `${spoken}, ${fault}` };
}

function shortened(text: string): string {
  return text.length > LONGEST_VALUE ? `${text.slice(0, LONGEST_VALUE)}…` : text;
}
