// Choice of a library or type, independent of VS Code.

import type { LibraryCandidate, LibraryKind, ProjectKind } from "../serverRequests";

export interface Choice {
  label: string;
  description: string;
  detail: string;
  candidate: LibraryCandidate;
}

/** Choices under a heading. Sections are ordered by probability. */
export interface Section {
  heading: string;
  choices: Choice[];
}

const KINDS: Record<ProjectKind, string> = { application: "application", tests: "tests", library: "library", type: "user type" };

/** Returns the cell's projects that can be added. A type needs public data, which are its fields. */
export function sections(candidates: readonly LibraryCandidate[], kind: LibraryKind): Section[] {
  const fitting = kind === "type" ? candidates.filter(({ publicData }) => publicData > 0) : [...candidates];
  const present = kind === "type" ? ({ types }: LibraryCandidate): readonly string[] => types : ({ libraries }: LibraryCandidate): readonly string[] => libraries;
  const isCircle = (candidate: LibraryCandidate): boolean => (kind === "type" ? candidate.typeCircle : candidate.libraryCircle);
  const isOther = ({ kind: other }: LibraryCandidate): boolean => other === "application" || other === "tests";
  const heading = (candidate: LibraryCandidate): number =>
    isCircle(candidate) ? 3 : present(candidate).length > 0 ? 2 : isOther(candidate) ? 1 : 0;
  const title = kind === "type" ? "User Types" : "Libraries";
  const headings = [title, "Applications", "Already There", "Would Use This Project in a Circle"];
  const found = headings.map((text, index) => ({
    heading: text,
    choices: fitting.filter((candidate) => heading(candidate) === index).map((candidate) => choice(candidate, kind, present(candidate))),
  }));
  return found.filter(({ choices }) => choices.length > 0);
}

function choice(candidate: LibraryCandidate, kind: LibraryKind, present: readonly string[]): Choice {
  const { uri, path, publicPrograms, publicData, fits } = candidate;
  const parts = [
    KINDS[candidate.kind],
    ...(kind === "type" ? [counted(publicData, "field")] : [counted(publicPrograms, "public program"), `${publicData} public data`]),
    ...(present.length === 0 ? [] : [`there as ${present.join(", ")}`]),
    ...(kind === "type" || fits.length === 0 ? [] : [`can be loaded as ${fits.join(", ")}`]),
  ];
  return { label: nameOf(uri), description: path, detail: parts.join(" · "), candidate };
}

function counted(count: number, what: string): string {
  return `${count} ${what}${count === 1 ? "" : "s"}`;
}

function nameOf(uri: string): string {
  return decodeURIComponent(uri.slice(uri.lastIndexOf("/") + 1)).replace(/\.pjx$/i, "");
}
