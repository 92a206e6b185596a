// Messages between the page and the editor around it. The tables are the result of the request `val3/data`.

import type * as server from "../serverRequests";

export type {
  Access, Column, Container, DataEdit, DataFinding, DataLocation as Place, DataPose, DataType, CellChange,
} from "../serverRequests";

export type Value = server.TableElement;

/** Row content: a variable, or a field of a value, which has no access. */
export type Datum = server.FieldContent & Partial<Pick<server.Datum, "access">>;

/** Tables without result ids and ranges, which only the editor reads. */
export type DataTables = Omit<server.DataTables, "resultId" | "data"> & { data: readonly Datum[] };

/** Replacement of items in a list. */
export type Replacement<Item> = Omit<server.ReplacedDatum, "items"> & { items: readonly Item[] };

/** Difference between the tables and the previous ones. */
export type DataChanges = Pick<server.DataChanges, "version" | "problem" | "values" | "findings"> & { data: Replacement<Datum> };

/** Line that uses a datum: text and location. */
export interface Use {
  name: string;
  file: string;
  uri: string;
  line: number;
  character: number;
  text: string;
}

/** Reason why nothing was changed, or the findings that the edit adds, if it was only checked. */
export type EditAnswer = Pick<server.EditDataResult, "refused" | "findings">;

/** Messages from the editor. */
export type FromEditor =
  | { kind: "tables"; tables: DataTables }
  | { kind: "changes"; changes: DataChanges }
  | { kind: "unavailable"; reason: string }
  | { kind: "reveal"; name: string; key?: string }
  | { kind: "answer"; id: number; answer?: unknown; fault?: string };

/** Requests of the page: parameters and responses. */
export interface Requests {
  edit: [{ edits: readonly server.DataEdit[]; check: boolean }, EditAnswer];
  rename: [{ name: string; as: string }, EditAnswer];
  uses: [{ names: readonly string[] }, readonly Use[]];
  poses: [{ names: readonly string[] }, readonly server.DataPose[]];
}
