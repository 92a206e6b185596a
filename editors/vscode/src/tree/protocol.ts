// Server responses to `val3/workspaceTree`, `val3/libraries` and `val3/delete` (docs/src/language-server.md).

import type { Location, Range } from "vscode-languageclient/node";

export type { Location, Position, Range } from "vscode-languageclient/node";

export type ProjectKind = "application" | "tests" | "library" | "type";

/** Element of the response to `val3/workspaceTree`, one for each `.pjx`. */
export interface Project {
  name: string;
  uri: string;
  kind: ProjectKind;
  /** Whether its dialect has user types. */
  hasTypes: boolean;
  programs: Program[];
  data: Data[];
  libraries: Reference[];
  types: Reference[];
}

export interface Item {
  name: string;
  /** Type, signature or path; may be empty. */
  detail: string;
  /** Location of the name. */
  location: Location;
  /** Range of the entire declaration. */
  range: Range;
}

export interface Program extends Item {
  public: boolean;
  /** Whether it needs no caller. */
  runs: boolean;
}

export interface Data extends Item {
  public: boolean;
  type: string;
  /** Sizes by dimension; empty for a collection. */
  sizes: number[];
  isCollection: boolean;
  /** Initial value of a single `num`, `bool` or `string`. */
  value: string | null;
}

/** A library identifier or a user type. */
export interface Reference extends Item {
  /** The `.pjx` to which it refers. */
  project: string | null;
  /** Libraries that programs load in its place. */
  loaded: string[];
}

/** Project that can be added as a library or type. */
export interface Candidate {
  uri: string;
  kind: ProjectKind;
  /** Unused name. */
  name: string;
  path: string;
  /** Identifiers under which it is already a library. */
  libraries: string[];
  /** Names under which it is already a type. */
  types: string[];
  publicPrograms: number;
  publicData: number;
  /** Library identifiers under which it can be loaded. */
  fits: string[];
  libraryCircle: boolean;
  typeCircle: boolean;
}

export interface LibraryList {
  hasTypes: boolean;
  candidates: Candidate[];
}

/** `Edit` is an edit of the protocol. */
export interface Deletion<Edit> {
  edit: Edit;
  /** Locations that use the deleted item. */
  uses: Location[];
}
