// The answers of the server to `val3/workspaceTree`, `val3/libraries` and `val3/delete` (docs/src/language-server.md).

import type { Location, Range } from "vscode-languageclient/node";

export type { Location, Position, Range } from "vscode-languageclient/node";

export type ProjectKind = "application" | "tests" | "library" | "type";

/** An element of the response to `val3/workspaceTree`, one for each `.pjx`. */
export interface Project {
  name: string;
  uri: string;
  kind: ProjectKind;
  /** Its dialect has user types. */
  hasTypes: boolean;
  programs: Program[];
  data: Data[];
  libraries: Reference[];
  types: Reference[];
}

export interface Item {
  name: string;
  /** A type, signature or path; may be empty. */
  detail: string;
  /** Of the name. */
  location: Location;
  /** Of the whole declaration. */
  range: Range;
}

export interface Program extends Item {
  public: boolean;
  /** It needs no caller. */
  runs: boolean;
}

export interface Data extends Item {
  public: boolean;
  type: string;
  /** Of each dimension; empty for a collection. */
  sizes: number[];
  isCollection: boolean;
  /** The initial value of a single `num`, `bool` or `string`. */
  value: string | null;
}

/** A library identifier or a user type. */
export interface Reference extends Item {
  /** The `.pjx` that it means. */
  project: string | null;
  /** The libraries that programs load in its place. */
  loaded: string[];
}

/** A project that can become a library or a type of another one. */
export interface Candidate {
  uri: string;
  kind: ProjectKind;
  /** A name that is still free. */
  name: string;
  path: string;
  /** The identifiers that it has as a library. */
  libraries: string[];
  /** The names that it has as a type. */
  types: string[];
  publicPrograms: number;
  publicData: number;
  /** The library identifiers under which it can be loaded. */
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
  /** The places that use what is deleted. */
  uses: Location[];
}
