// Maps code views to files, because the debug adapter supports only files.
//
// Requests for a view are rewritten for its file. Breakpoints of the view and the file are sent in one
// `setBreakpoints`, which replaces all breakpoints of a file. A stop is shown in the code view if it is visible,
// otherwise in the file.

import type { DebugProtocol as Protocol } from "@vscode/debugprotocol";
import type { Mapping } from "../codeView/mapping";

/** Code view as a source. */
export interface View {
  /** URI, used in place of a path. */
  code: string;
  name: string;
  /** Path of the file. */
  file: string;
  mapping: Mapping;
}

export interface Views {
  /** Finds the view with this URI; `undefined` for the path of a file. */
  find(path: string): Promise<View | undefined>;
  /** Returns the visible views of a file. */
  shown(file: string): View[];
}

/** Line in a source, optionally with columns. Lines and columns start at 1. */
interface Place {
  line?: number;
  column?: number;
  endLine?: number;
  endColumn?: number;
  source?: Protocol.Source;
}

type Translation = (response: Protocol.Response) => void;

export class SourceTranslator {
  /** Conversions for the responses to pending requests. */
  private readonly pending = new Map<number, Translation>();
  /** Breakpoints by file, and by the path or view in which they were set. */
  private readonly breakpoints = new Map<string, Map<string, Protocol.SourceBreakpoint[]>>();
  /** Views by breakpoint number. */
  private readonly owners = new Map<number, View>();

  constructor(private readonly views: Views) {}

  /** Converts a message from the client for the adapter. */
  async toAdapter(message: Protocol.ProtocolMessage): Promise<Protocol.ProtocolMessage> {
    const request = message as Protocol.Request;
    const { source } = (request.arguments ?? {}) as { source?: Protocol.Source };
    if (message.type !== "request" || source?.path === undefined) {
      return message;
    }
    const view = await this.views.find(source.path);
    if (request.command === "setBreakpoints") {
      return this.setBreakpoints(request as Protocol.SetBreakpointsRequest, source.path, view);
    }
    return view === undefined ? message : this.atFile(request, view);
  }

  /** Converts a message from the adapter for the client. */
  toClient(message: Protocol.ProtocolMessage): Protocol.ProtocolMessage {
    if (message.type === "response") {
      const response = message as Protocol.Response;
      this.pending.get(response.request_seq)?.(response);
      this.pending.delete(response.request_seq);
      this.showFrames(response);
    } else if (message.type === "event") {
      this.showEvent(message as Protocol.Event);
    }
    return message;
  }

  private setBreakpoints(request: Protocol.SetBreakpointsRequest, path: string, view: View | undefined): Protocol.Request {
    const file = view?.file ?? path;
    const own = breakpointsOf(request.arguments).map((wanted) => (view === undefined ? wanted : placeInFile(wanted, view.mapping)));
    const ofFile = this.breakpoints.get(file) ?? new Map<string, Protocol.SourceBreakpoint[]>();
    ofFile.set(path, own);
    this.breakpoints.set(file, ofFile);
    const others = [...ofFile].filter(([place]) => place !== path).flatMap(([, breakpoints]) => breakpoints);
    this.pending.set(request.seq, (response) => {
      const body = response.body as Protocol.SetBreakpointsResponse["body"] | undefined;
      if (body !== undefined) {
        body.breakpoints = body.breakpoints.slice(0, own.length);
        body.breakpoints.forEach((found) => this.claim(found, view));
      }
    });
    const { source, sourceModified } = request.arguments;
    return { ...request, arguments: { source: fileSource(source, file), breakpoints: [...own, ...others], sourceModified } };
  }

  /** Records the view in which a breakpoint was set; `undefined` for a breakpoint in a file. */
  private claim(found: Protocol.Breakpoint, view: View | undefined): void {
    if (found.id !== undefined) {
      this.owners.delete(found.id);
    }
    if (view !== undefined) {
      if (found.id !== undefined) {
        this.owners.set(found.id, view);
      }
      showIn(found, view);
    }
  }

  private atFile(request: Protocol.Request, view: View): Protocol.Request {
    const place = request.arguments as Place;
    this.pending.set(request.seq, ({ body }) => {
      const { breakpoints = [], targets = [] } = (body ?? {}) as { breakpoints?: Place[]; targets?: Place[] };
      [...breakpoints, ...targets].forEach((found) => showIn(found, view));
    });
    return { ...request, arguments: { ...placeInFile(place, view.mapping), source: fileSource(place.source, view.file) } };
  }

  private showFrames(response: Protocol.Response): void {
    if (response.command === "stackTrace" && response.success) {
      for (const frame of (response as Protocol.StackTraceResponse).body.stackFrames) {
        // VS Code selects a range, so that the next typed character would replace the statement.
        delete frame.endLine;
        delete frame.endColumn;
        this.show(frame);
      }
    }
  }

  private showEvent({ event, body }: Protocol.Event): void {
    if (event === "output") {
      this.show(body as Protocol.OutputEvent["body"]);
    } else if (event === "breakpoint") {
      const { breakpoint } = body as Protocol.BreakpointEvent["body"];
      const view = this.owners.get(breakpoint.id ?? 0);
      if (view !== undefined) {
        showIn(breakpoint, view);
      }
    }
  }

  /** Converts a location in a file to a location in a visible view, if any. */
  private show(place: Place): void {
    const view = this.views.shown(place.source?.path ?? "").find(({ mapping }) => lineInCode(place.line, mapping) !== undefined);
    if (view !== undefined) {
      showIn(place, view);
    }
  }
}

function breakpointsOf({ breakpoints, lines }: Protocol.SetBreakpointsArguments): Protocol.SourceBreakpoint[] {
  return breakpoints ?? lines?.map((line) => ({ line })) ?? [];
}

function fileSource(source: Protocol.Source | undefined, file: string): Protocol.Source {
  return { ...source, path: file, name: file.slice(Math.max(file.lastIndexOf("/"), file.lastIndexOf("\\")) + 1) };
}

/** Converts a location in a view to a location in its file. */
function placeInFile<Given extends Place>(place: Given, mapping: Mapping): Given {
  const inFile = (line: number | undefined): number | undefined =>
    line === undefined ? undefined : mapping.toFile({ line: line - 1, character: 0 }).line + 1;
  // A line of code is a line of the file. Its first column may differ, and a breakpoint needs none.
  return { ...place, line: inFile(place.line), endLine: inFile(place.endLine), column: undefined, endColumn: undefined };
}

/** Converts a location in a file to a location in a view: the first line if it is outside the code. */
function showIn(place: Place, view: View): void {
  place.source = { ...place.source, name: view.name, path: view.code };
  for (const [line, column] of [["line", "column"], ["endLine", "endColumn"]] as const) {
    const inFile = { line: place[line], column: place[column] };
    if (inFile.line !== undefined) {
      place[line] = lineInCode(inFile.line, view.mapping) ?? 1;
    }
    if (inFile.column !== undefined) {
      place[column] = columnInCode(inFile, view.mapping);
    }
  }
}

/** Returns the column in a view for a column in its file; the first column outside the code. Both start at 1. */
function columnInCode({ line, column = 1 }: Place, mapping: Mapping): number {
  const found = line === undefined ? undefined : mapping.toCode({ line: line - 1, character: column - 1 });
  return (found?.character ?? 0) + 1;
}

/** Returns the line in a view for a line in its file; `undefined` outside the code. Both start at 1. */
export function lineInCode(line: number | undefined, mapping: Mapping): number | undefined {
  const start = { line: (line ?? 0) - 1, character: 0 };
  const found = line === undefined ? undefined : mapping.rangeToCode({ start, end: { line, character: 0 } });
  return found && found.start.line + 1;
}
