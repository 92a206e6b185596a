// Code in a program file, and the conversion between offsets in the code and in the file. Pure functions.
//
// The code is the content of a <Code> element: the CDATA sections, or, in the old dialect, the text with entities.
// Offsets in the code and in the file are in UTF-16 units.

/** Corresponding ranges of the code and the file; if their lengths are equal, so are the texts. */
interface Chunk {
  code: number;
  file: number;
  codeLength: number;
  fileLength: number;
}

/** Replacement in a text. */
export interface Replacement {
  start: number;
  end: number;
  text: string;
}

/** Program in a file, with its name and opening tag, if it has one. */
export interface Program {
  name: string;
  tagStart: number;
  tagEnd: number;
  codeStart: number;
}

/** Comments and sections that may mention code, and the tags around code. */
const OUTSIDE = /<!--[^]*?(?:-->|$)|<!\[CDATA\[[^]*?(?:\]\]>|$)|<(?:Program|program)\s[^>]*>|<(?:Code|code)(?:\s[^>]*)?>/g;
const PIECE = /<!\[CDATA\[([^]*?)(?:\]\]>|$)|<!--[^]*?-->|&(?:#[xX][0-9a-fA-F]+|#\d+|\w+);|<\/(?:Code|code)\s*>|[^<&]+|[^]/g;
const CDATA_OPEN = "<![CDATA[";
const ENTITIES: Record<string, string> = { "&lt;": "<", "&gt;": ">", "&amp;": "&", "&quot;": '"', "&apos;": "'" };

/** Code of a program in a file. */
export class Projection {
  private constructor(
    /** Code without XML and entities. */
    readonly code: string,
    /** Program name; may be empty. */
    readonly program: string,
    private readonly chunks: Chunk[],
    private readonly isCdata: boolean,
    private readonly fileStart: number,
    private readonly headStart: number,
  ) {}

  /** Returns the code of program number `index` in the file; `undefined` if it has none. */
  static of(file: string, index = 0): Projection | undefined {
    const program = programsOf(file)[index];
    if (program === undefined) {
      return undefined;
    }
    const start = program.codeStart;
    const pieces = readPieces(file, start);
    const isCdata = pieces.some((piece) => piece.isCdata);
    const kept = isCdata ? pieces.filter((piece) => piece.isCdata || piece.text.trim() !== "") : pieces;
    const chunks: Chunk[] = [];
    let code = "";
    for (const piece of kept) {
      chunks.push({ code: code.length, file: piece.start, codeLength: piece.text.length, fileLength: piece.length });
      code += piece.text;
    }
    return new Projection(code, program.name, chunks, isCdata, start, program.tagStart);
  }

  /** Returns the offset in the file for an offset in the code. */
  toFile(offset: number): number {
    const chunk = this.chunks.findLast((chunk) => chunk.code <= offset) ?? this.chunks[0];
    if (chunk === undefined) {
      return this.fileStart;
    }
    const within = offset - chunk.code;
    return chunk.file + (within >= chunk.codeLength ? chunk.fileLength : isVerbatim(chunk) ? within : 0);
  }

  /** Returns the offset in the code for an offset in the file; `undefined` outside the code. */
  toCode(offset: number): number | undefined {
    const first = this.chunks[0];
    const last = this.chunks[this.chunks.length - 1];
    if (first === undefined || last === undefined) {
      return offset === this.fileStart ? 0 : undefined;
    }
    if (offset < first.file || offset > last.file + last.fileLength) {
      return undefined;
    }
    const chunk = this.chunks.findLast((chunk) => chunk.file <= offset) ?? first;
    const within = offset - chunk.file;
    return chunk.code + (isVerbatim(chunk) ? Math.min(within, chunk.codeLength) : within >= chunk.fileLength ? chunk.codeLength : 0);
  }

  /** Whether an offset in the file is in the program's head, before its code. */
  isHead(offset: number): boolean {
    return this.headStart <= offset && offset < this.fileStart;
  }

  /** Returns the replacement in the file that changes its code to `code`; `undefined` if the code is equal. */
  replacement(code: string): Replacement | undefined {
    const change = difference(this.code, code);
    if (change === undefined) {
      return undefined;
    }
    const whole = this.isCdata ? aroundSectionEnd(change, this.code) : change;
    const text = this.isCdata ? whole.text.replaceAll("]]>", "]]]]><![CDATA[>") : escape(whole.text);
    return { start: this.toFile(whole.start), end: this.endInFile(whole), text };
  }

  /** Converts text from the file, for example from a text edit, to code. */
  decode(text: string): string {
    return this.isCdata ? text.replaceAll("]]]]><![CDATA[>", "]]>") : unescape(text);
  }

  /** Returns the end in the file. An empty replacement ends where it starts, also between two CDATA sections. */
  private endInFile(change: Replacement): number {
    if (change.end === change.start) {
      return this.toFile(change.start);
    }
    const chunk = this.chunks.findLast((chunk) => chunk.code < change.end);
    const within = chunk === undefined ? 0 : change.end - chunk.code;
    return chunk === undefined ? this.fileStart : chunk.file + (isVerbatim(chunk) ? within : chunk.fileLength);
  }
}

/** Returns the shortest single replacement that converts `before` to `after`. */
export function difference(before: string, after: string): Replacement | undefined {
  if (before === after) {
    return undefined;
  }
  const shorter = Math.min(before.length, after.length);
  let start = 0;
  while (start < shorter && before[start] === after[start]) {
    start += 1;
  }
  let tail = 0;
  while (tail < shorter - start && before[before.length - 1 - tail] === after[after.length - 1 - tail]) {
    tail += 1;
  }
  return { start, end: before.length - tail, text: after.slice(start, after.length - tail) };
}

interface Piece {
  start: number;
  length: number;
  text: string;
  isCdata: boolean;
}

function isVerbatim(chunk: Chunk): boolean {
  return chunk.codeLength === chunk.fileLength;
}

/** Returns the programs in a file that have code. Comments and descriptions that mention the tags are ignored. */
export function programsOf(file: string): Program[] {
  const programs: Program[] = [];
  let tag = { name: "", tagStart: 0, tagEnd: 0 };
  for (const { 0: text, index } of file.matchAll(OUTSIDE)) {
    const end = index + text.length;
    if (/^<program/i.test(text)) {
      tag = { name: /\sname\s*=\s*["']([^"']*)/.exec(text)?.[1] ?? "", tagStart: index, tagEnd: end };
    } else if (/^<code/i.test(text) && !text.endsWith("/>")) {
      programs.push({ ...tag, codeStart: end });
    }
  }
  return programs;
}

function readPieces(file: string, start: number): Piece[] {
  const pieces: Piece[] = [];
  for (const match of file.slice(start).matchAll(PIECE)) {
    const at = start + match.index;
    const [whole, section] = match;
    if (/^<\/code/i.test(whole)) {
      break;
    } else if (section !== undefined) {
      pieces.push({ start: at + CDATA_OPEN.length, length: section.length, text: section, isCdata: true });
    } else if (!whole.startsWith("<!--")) {
      pieces.push({ start: at, length: whole.length, text: unescape(whole), isCdata: false });
    }
  }
  return pieces;
}

/** Extends a change next to `]` or `>`, because it may create or destroy `]]>`, which ends a section. */
function aroundSectionEnd(change: Replacement, code: string): Replacement {
  let { start, end } = change;
  while (start > 0 && code[start - 1] === "]") {
    start -= 1;
  }
  while (end < code.length && (code[end] === "]" || code[end] === ">")) {
    end += 1;
  }
  return { start, end, text: code.slice(start, change.start) + change.text + code.slice(change.end, end) };
}

function escape(code: string): string {
  const names: Record<string, string> = { "<": "&lt;", ">": "&gt;", "&": "&amp;", '"': "&quot;" };
  return code.replace(/[<>&"]/g, (letter) => names[letter] ?? letter);
}

function unescape(text: string): string {
  return text.replace(/&(?:#[xX]([0-9a-fA-F]+)|#(\d+)|\w+);/g, (entity, hex?: string, decimal?: string) => {
    const number = hex !== undefined ? parseInt(hex, 16) : decimal !== undefined ? parseInt(decimal, 10) : undefined;
    if (number === undefined) {
      return ENTITIES[entity] ?? entity;
    }
    return number <= 0x10ffff ? String.fromCodePoint(number) : entity;
  });
}
