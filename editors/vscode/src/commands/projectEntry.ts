// The entry of a program in the list of its project. Knows text alone.

import type { Replacement } from "../codeView/projection";

/** The project is of the dialect that controllers of the s6 series and older write. */
export function isOld(project: string): boolean {
  return project.includes("ProjectNameSpace");
}

/**
 * The edit that lists `name`, in front of the first program that follows by name, else behind the last. Nothing where
 * it is listed already, or where there is no list.
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
