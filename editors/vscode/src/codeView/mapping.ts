// Converts between positions in a code view and in its file, for one version of the file.

import { Projection } from "./projection";

/** Position as in the protocol and VS Code. Characters are UTF-16 units. */
export interface Position {
  line: number;
  character: number;
}

export interface Range {
  start: Position;
  end: Position;
}

export class Mapping {
  private readonly code: Lines;
  private readonly file: Lines;

  constructor(readonly projection: Projection, fileText: string) {
    this.code = new Lines(projection.code);
    this.file = new Lines(fileText);
  }

  /** Returns the mapping; `undefined` if the file contains no code. */
  static of(file: string, index: number): Mapping | undefined {
    const projection = Projection.of(file, index);
    return projection && new Mapping(projection, file);
  }

  toFile(position: Position): Position {
    return this.file.positionAt(this.projection.toFile(this.code.offsetAt(position)));
  }

  rangeToFile(range: Range): Range {
    return { start: this.toFile(range.start), end: this.toFile(range.end) };
  }

  offsetInFile(position: Position): number {
    return this.file.offsetAt(position);
  }

  /** Whether a position in the file is in the program's head, before its code. */
  isHead(position: Position): boolean {
    return this.projection.isHead(this.file.offsetAt(position));
  }

  /** Returns the position for an offset in the code. */
  inCode(offset: number): Position {
    return this.code.positionAt(Math.min(offset, this.projection.code.length));
  }

  wholeCode(): Range {
    return { start: { line: 0, character: 0 }, end: this.code.end() };
  }

  /** Returns the position in the code; `undefined` outside the code. */
  toCode(position: Position): Position | undefined {
    const offset = this.projection.toCode(this.file.offsetAt(position));
    return offset === undefined ? undefined : this.code.positionAt(offset);
  }

  /** Returns the part of a range that is in the code; `undefined` if the range only touches it. */
  rangeToCode(range: Range): Range | undefined {
    const start = this.toCode(range.start);
    const end = this.toCode(range.end);
    if (start !== undefined && end !== undefined) {
      return { start, end };
    }
    const whole = this.rangeToFile(this.wholeCode());
    const overlaps = isBefore(range.start, whole.end) && isBefore(whole.start, range.end);
    return overlaps ? { start: start ?? { line: 0, character: 0 }, end: end ?? this.code.end() } : undefined;
  }
}

function isBefore(left: Position, right: Position): boolean {
  return left.line < right.line || (left.line === right.line && left.character < right.character);
}

/** Converts between offsets and positions in a text. */
class Lines {
  private readonly starts: number[];

  constructor(private readonly text: string) {
    this.starts = [0, ...Array.from(text.matchAll(/\r\n|\r|\n/g), (end) => end.index + end[0].length)];
  }

  offsetAt({ line, character }: Position): number {
    const start = this.starts[line];
    if (start === undefined) {
      return this.text.length;
    }
    return Math.min(start + character, this.starts[line + 1] ?? this.text.length);
  }

  positionAt(offset: number): Position {
    const line = this.starts.findLastIndex((start) => start <= offset);
    return { line, character: offset - (this.starts[line] ?? 0) };
  }

  end(): Position {
    return this.positionAt(this.text.length);
  }
}
