// Entry of a program in the project's list. Pure functions.

import type { Replacement } from "../codeView/projection";

/** Whether the project is in the dialect of s6 and older controllers. */
export function isOld(project: string): boolean {
  return project.includes("ProjectNameSpace");
}

/**
 * Returns the edit that lists `name` in alphabetical order: before the next program, or after the last one. `undefined`
 * if the name is already listed, or if there is no list.
 */
export function entry(project: string, name: string): Replacement | undefined {
  const eol = project.includes("\r\n") ? "\r\n" : "\n";
  const element = `<${isOld(project) ? "program" : "Program"} file="${name}.pgx" />`;
  const entries = [...project.matchAll(/^([ \t]*)<[Pp]rogram\s[^>]*?file="([^"]+)\.pgx"[^>]*>/gm)].map((match) => {
    const [whole, indent = "", other = ""] = match;
    return { start: match.index, end: match.index + whole.length, indent, other: other.toLowerCase() };
  });
  if (entries.some(({ other }) => other === name.toLowerCase())) {
    return undefined;
  }
  const next = entries.find(({ other }) => other > name.toLowerCase());
  const last = entries.at(-1);
  if (next !== undefined) {
    return { start: next.start, end: next.start, text: next.indent + element + eol };
  }
  return last === undefined ? firstEntry(project, element, eol) : { start: last.end, end: last.end, text: eol + last.indent + element };
}

function firstEntry(project: string, element: string, eol: string): Replacement | undefined {
  const list = /([ \t]*)<(Programs|programSection)\s*(?:\/>|>\s*<\/\2>)/.exec(project);
  if (list === null) {
    return undefined;
  }
  const [whole, indent = "", tag = ""] = list;
  const text = `${indent}<${tag}>${eol}${indent}  ${element}${eol}${indent}</${tag}>`;
  return { start: list.index, end: list.index + whole.length, text };
}
