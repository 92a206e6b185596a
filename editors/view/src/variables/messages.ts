// Messages between the page and the editor around it. docs/src/language-server.md describes the variables.

export type Container = "element" | "array" | "collection";
export type Passing = "value" | "reference";

export interface Parameter {
  name: string;
  type: string;
  container: Container;
  dimensions: number;
  passing: Passing;
  uses: number;
}

export interface Local {
  name: string;
  type: string;
  container: Container;
  size: number[];
  uses: number;
}

export interface Variables {
  uri: string;
  version: number | null;
  program: string;
  parameters: Parameter[];
  locals: Local[];
  types: string[];
  isOld: boolean;
  /** Reason why the parameters cannot be changed. */
  fixed: string | null;
}

/** Parameter in the list after an edit. */
export interface ParameterEdit extends Omit<Parameter, "uses"> {
  /** Previous index; absent for a new parameter. */
  from?: number;
  /** Expression that callers pass for a new parameter. */
  argument?: string;
}

export interface LocalEdit extends Omit<Local, "uses" | "container"> {
  from?: number;
}

export interface Edits {
  parameters?: ParameterEdit[];
  locals?: LocalEdit[];
}

export type ToPage =
  | { kind: "variables"; variables: Variables | null; hasProgram: boolean }
  | { kind: "answer"; id: number; refused: string | null };

export type FromPage =
  | { command: "ready" }
  | { command: "edit"; id: number; uri: string; version: number | null; program: string; edits: Edits };
