// Programs of the application and its libraries.

import type * as wire from "../../wire";

/** Line of a program's file, from 1. */
export interface CodeLine {
  program: string;
  line: number;
  file: string;
}

/** Line of which the file may be unknown. */
export type NamedLine = Omit<CodeLine, "file"> & { file?: string | undefined };

/** Program with its code. */
export type Program = wire.ProgramCode & { application: string };

/** Programs by their keys. */
export type ProgramList = ReadonlyMap<string, Program>;

/** Returns the key of a program: a file may contain several programs. */
export function keyOf({ program, file }: Pick<CodeLine, "program" | "file">): string {
  return `${file}\n${program}`;
}

/** Returns the list with the programs of a message. They replace programs with the same name and file. */
export function withPrograms(list: ProgramList, { application, programs }: wire.ProgramsMessage): ProgramList {
  const all = new Map(list);
  programs.forEach((program) => all.set(keyOf({ program: program.name, file: program.file }), { ...program, application }));
  return all;
}

/** Returns the program of a line. Without a file, the name must be that of a single program. */
export function programOf(list: ProgramList, { program, file }: NamedLine): Program | undefined {
  if (file !== undefined && file !== "") {
    return list.get(keyOf({ program, file }));
  }
  const named = [...list.values()].filter(({ name }) => name === program);
  return named.length === 1 ? named[0] : undefined;
}

/** Programs of an application or library. */
export interface ProgramGroup {
  application: string;
  programs: readonly Program[];
}

/** Returns the programs by name, first those of the application. */
export function groupsOf(list: ProgramList, application: string | undefined): ProgramGroup[] {
  const groups = new Map<string, Program[]>(application === undefined ? [] : [[application, []]]);
  for (const program of list.values()) {
    const group = groups.get(program.application) ?? [];
    group.push(program);
    groups.set(program.application, group);
  }
  return [...groups].filter(([, programs]) => programs.length > 0)
    .map(([name, programs]) => ({ application: name, programs: programs.sort((left, right) => left.name.localeCompare(right.name)) }));
}
