// The features of the language server in code views.
//
// The server only knows files. A request about a view becomes one about its file, and the ranges of the response become
// ranges of the view. Edits of the whole workspace stay edits of files, and the views follow them.

import { type Lens, LENSES, lensesToCode } from "./lenses";
import type { Mapping, Position, Range } from "./mapping";
import { type Symbol, SYMBOLS, symbolsToCode } from "./symbols";
import { toCodeTokens } from "./tokens";

/** A view and its file, as addresses of the protocol. */
export interface Target {
  code: string;
  file: string;
  mapping: Mapping;
}

type Json = unknown;
type JsonObject = Record<string, Json>;

/** Properties that only the server reads, or that are about files. */
const OPAQUE = new Set(["data", "command", "edit", "changes", "documentChanges", "legend"]);

/** The parameters of a request about the view, as parameters about its file. */
export function toFile(params: Json, target: Target): Json {
  if (Array.isArray(params)) {
    return params.map((item) => toFile(item, target));
  } else if (isRange(params)) {
    return target.mapping.rangeToFile(params);
  } else if (isPosition(params)) {
    return target.mapping.toFile(params);
  } else if (!isObject(params)) {
    return params === target.code ? target.file : params;
  }
  return mapValues(params, (key, value) => (OPAQUE.has(key) ? value : toFile(value, target)));
}

/** The response about the file, converted for the view. Ranges outside of its code are left out. */
export function toCode(method: string, answer: Json, target: Target): Json {
  if (method.startsWith("textDocument/semanticTokens/")) {
    return toCodeTokens(answer, target.mapping);
  } else if (method === "textDocument/foldingRange") {
    return (answer as JsonObject[] | null)?.flatMap((fold) => toCodeFold(fold, target) ?? []) ?? null;
  } else if (method === LENSES) {
    return lensesToCode(answer as Lens[] | null, target);
  } else if (method === SYMBOLS) {
    return symbolsToCode(answer as Symbol[] | null, target);
  } else if (method === "textDocument/completion") {
    return toCodeValue(withOutsideEdits(answer, target), target) ?? null;
  }
  return toCodeValue(answer, target) ?? null;
}

function toCodeValue(value: Json, target: Target): Json {
  if (Array.isArray(value)) {
    return value.map((item) => toCodeValue(item, target)).filter((item) => item !== undefined);
  } else if (isRange(value)) {
    return target.mapping.rangeToCode(value);
  } else if (isPosition(value)) {
    return target.mapping.toCode(value);
  } else if (!isObject(value)) {
    return value;
  } else if (typeof value.uri === "string" || typeof value.targetUri === "string") {
    return toCodeLocation(value, target);
  } else if (isObject(value.from) && value.from.uri !== target.file) {
    // A call from another file, with ranges of that file.
    return value;
  }
  return toCodeObject(value, target);
}

/** An object with a range outside of the code becomes nothing; of a nested one (a parent) only the property is left out. */
function toCodeObject(value: JsonObject, target: Target): JsonObject | undefined {
  const result: JsonObject = {};
  for (const [key, part] of Object.entries(value)) {
    const mapped = OPAQUE.has(key) ? part : toCodeValue(part, target);
    if (mapped === undefined && (isRange(part) || isPosition(part))) {
      return undefined;
    } else if (mapped !== undefined) {
      result[key] = key === "newText" && typeof mapped === "string" ? target.mapping.projection.decode(mapped) : mapped;
    }
  }
  return result;
}

/** A location in the code becomes one of the view. Any other, in this file or elsewhere, stays one of a file. */
function toCodeLocation(value: JsonObject, target: Target): JsonObject {
  const inFile = (value.uri ?? value.targetUri) === target.file;
  const mapped = inFile ? toCodeObject(value, target) : undefined;
  if (mapped === undefined) {
    const origin = value.originSelectionRange;
    return isRange(origin) ? { ...value, originSelectionRange: target.mapping.rangeToCode(origin) } : value;
  }
  return { ...mapped, [value.uri === undefined ? "targetUri" : "uri"]: target.code };
}

function toCodeFold(fold: JsonObject, target: Target): JsonObject | undefined {
  const start = target.mapping.toCode({ line: Number(fold.startLine), character: Number(fold.startCharacter ?? 1e6) });
  const end = target.mapping.toCode({ line: Number(fold.endLine), character: Number(fold.endCharacter ?? 0) });
  return start && end && { ...fold, startLine: start.line, endLine: end.line, startCharacter: undefined, endCharacter: undefined };
}

/** The command that makes the edits of a completion that lie outside of the code, such as a new local, and then runs the
 * command that the completion has itself. */
export const APPLY_EDITS = "val3.applyEdits";

function withOutsideEdits(answer: Json, target: Target): Json {
  const list = isObject(answer) && Array.isArray(answer.items) ? answer.items : answer;
  if (!Array.isArray(list)) {
    return answer;
  }
  const items = list.map((item: JsonObject) => {
    const edits = (item.additionalTextEdits ?? []) as { range: Range }[];
    const outside = edits.filter((edit) => target.mapping.rangeToCode(edit.range) === undefined);
    const command = { title: "", command: APPLY_EDITS, arguments: [target.file, outside, item.command] };
    return outside.length === 0 ? item : { ...item, command };
  });
  return list === answer ? items : { ...(answer as JsonObject), items };
}

function mapValues(object: JsonObject, change: (key: string, value: Json) => Json): JsonObject {
  return Object.fromEntries(Object.entries(object).map(([key, value]) => [key, change(key, value)]));
}

function isObject(value: Json): value is JsonObject {
  return typeof value === "object" && value !== null && !Array.isArray(value);
}

function isPosition(value: Json): value is Position {
  return isObject(value) && typeof value.line === "number" && typeof value.character === "number";
}

function isRange(value: Json): value is Range {
  return isObject(value) && isPosition(value.start) && isPosition(value.end);
}
