// Positions of a code view as positions of its file, and back, for one version of the file.

import { Projection } from "./projection";

/** The form that the protocol and VS Code share. Characters are UTF-16 units. */
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

  /** Nothing if the file has no code. */
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

  /** Whether a position of the file is in the head of the program, before its code. */
  isHead(position: Position): boolean {
    return this.projection.isHead(this.file.offsetAt(position));
  }

  /** The position of an offset in the code. */
  inCode(offset: number): Position {
    return this.code.positionAt(Math.min(offset, this.projection.code.length));
  }

  wholeCode(): Range {
    return { start: { line: 0, character: 0 }, end: this.code.end() };
  }

  /** Nothing for a position outside of the code. */
  toCode(position: Position): Position | undefined {
    const offset = this.projection.toCode(this.file.offsetAt(position));
    return offset === undefined ? undefined : this.code.positionAt(offset);
  }

  /** The part of a range that is in the code; nothing if the range only touches it. */
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

/** Offsets and positions of one text. */
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
