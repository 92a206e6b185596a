// Messages between the page and the editor around it. docs/src/language-server.md describes the variables.

import type * as server from "../serverRequests";

export type { ContainerKind as Container, LocalEdit, ParameterEdit, Passing } from "../serverRequests";

export type Edits = server.VariableEdits;
export type Parameter = Omit<server.Parameter, "range">;
export type Local = Omit<server.Local, "range">;

/** Variables without ranges, which only the editor reads. */
export type Variables = Omit<server.VariablesResult, "parameters" | "locals"> & { parameters: readonly Parameter[]; locals: readonly Local[] };

export type ToPage =
  | { kind: "variables"; variables: Variables | null; hasProgram: boolean }
  | { kind: "answer"; id: number; refused: string | null };

export type FromPage =
  | { command: "ready" }
  | ({ command: "edit"; id: number } & server.EditVariablesParams);
