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

/**
 * Returns the programs of messages in their order, of which the first `passed` ones are not later than the shown time. A
 * library may be loaded again after its files have changed: the last passed version of a program counts, otherwise its
 * first one.
 */
export function programsOf(messages: readonly wire.ProgramsMessage[], passed: number): ProgramList {
  const all = new Map<string, Program>();
  messages.forEach(({ application, programs }, index) => {
    for (const program of programs) {
      const key = keyOf({ program: program.name, file: program.file });
      if (index < passed || !all.has(key)) {
        all.set(key, { ...program, application });
      }
    }
  });
  return all;
}

/** Returns the program of a line. Without a file, only one program may have the name. */
export function programOf(list: ProgramList, { program, file }: NamedLine): Program | undefined {
  if (file !== undefined && file !== "") {
    return list.get(keyOf({ program, file }));
  }
  const named = [...list.values()].filter(({ name }) => name === program);
  return named.length === 1 ? named[0] : undefined;
}

/** Programs by application or library. */
export interface ProgramGroup {
  application: string;
  programs: readonly Program[];
}

/** Returns the programs by name, first the application's. */
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
