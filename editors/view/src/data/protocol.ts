// Messages between the page and the editor around it. The tables are the result of the request `val3/data`.

export interface DataTables {
  version: number | null;
  dialect: "old" | "new";
  /** Reason why the file cannot be edited as tables. */
  problem: string | null;
  types: readonly DataType[];
  data: readonly Datum[];
  findings: readonly DataFinding[];
}

/** Replacement of items in a list. */
export interface Replacement<Item> {
  start: number;
  deleteCount: number;
  items: readonly Item[];
}

/** Difference between the tables and the previous ones. */
export interface DataChanges {
  version: number | null;
  problem: string | null;
  data: Replacement<Datum>;
  /**
   * null if the data contain all their values. Otherwise the only new datum contains some values, which replace these
   * values of the previous datum.
   */
  values: { start: number; deleteCount: number } | null;
  /** null if the findings are not computed yet: the previous ones remain. */
  findings: Replacement<DataFinding> | null;
}

export interface DataType {
  name: string;
  columns: readonly Column[];
  /** Fields of a user type, which has no columns. */
  fields: readonly FieldType[];
  containers: readonly Container[];
}

export interface FieldType {
  name: string;
  type: string;
  container: Container;
  size: readonly number[];
}

export type Container = "array" | "collection";
export type Access = "public" | "private";

export interface Column {
  id: string;
  title: string;
  unit: string | null;
  kind: "number" | "text" | "bool" | "choice" | "father" | "link";
  choices: readonly string[];
  default: string;
}

export interface Datum {
  name: string;
  access: Access;
  type: string;
  container: Container;
  /** Sizes by dimension; for a collection the number of keys. */
  size: readonly number[];
  /** Only the values that the file contains; complete for a collection. */
  values: readonly Value[];
}

export interface Value {
  key: string;
  /** By column; null for the default. */
  texts: readonly (string | null)[];
  fields?: readonly Datum[];
}

export interface Place {
  name: string;
  key?: string;
  /** Path of fields below the element. */
  within?: readonly Step[];
}

export interface Step {
  name: string;
  /** Absent or empty for the container itself. */
  key?: string;
}

export interface DataFinding {
  place: Place;
  column: string | null;
  severity: "error" | "warning" | "information" | "hint";
  code: string;
  message: string;
}

export interface CellChange {
  place: Place;
  column: string;
  text: string | null;
}

export type DataEdit =
  | { kind: "set"; cells: readonly CellChange[] }
  | { kind: "add"; name: string; type: string; access: Access; container: Container; size: readonly number[]; after?: string }
  | { kind: "duplicate"; name: string; as: string }
  | { kind: "delete"; names: readonly string[] }
  | { kind: "access"; names: readonly string[]; access: Access }
  | { kind: "resize"; place: Place; size: readonly number[] }
  | { kind: "addKey"; place: Place; key: string }
  | { kind: "removeKey"; place: Place; keys: readonly string[] }
  | { kind: "renameKey"; place: Place; key: string; as: string };

/** An element's pose, and whether the arm reaches it. */
export interface DataPose {
  name: string;
  key: string;
  /** null if it is unknown. */
  world: readonly number[] | null;
  chain: string;
  reach: "reachable" | "outOfReach" | null;
  why: string | null;
  joints: readonly number[] | null;
}

/** Use of a datum: the text and location of its line. */
export interface Use {
  name: string;
  file: string;
  uri: string;
  line: number;
  character: number;
  text: string;
}

export interface EditAnswer {
  /** Reason why nothing was changed. */
  refused: string | null;
  /** Findings that the edit adds, if it was only checked. */
  findings: readonly DataFinding[];
}

/** Messages from the editor. */
export type FromEditor =
  | { kind: "tables"; tables: DataTables }
  | { kind: "changes"; changes: DataChanges }
  | { kind: "unavailable"; reason: string }
  | { kind: "reveal"; name: string; key?: string }
  | { kind: "answer"; id: number; answer?: unknown; fault?: string };

/** Requests of the page: parameters and responses. */
export interface Requests {
  edit: [{ edits: readonly DataEdit[]; check: boolean }, EditAnswer];
  rename: [{ name: string; as: string }, EditAnswer];
  uses: [{ names: readonly string[] }, readonly Use[]];
  poses: [{ names: readonly string[] }, readonly DataPose[]];
}
