// Language server features in code views.
//
// The server supports only files. A request about a view is converted to a request about its file, and the ranges in
// the response are converted to ranges in the view. Edits of the entire workspace remain edits of files, and the views
// are updated.

import { type Lens, LENSES, lensesToCode } from "./lenses";
import type { Mapping, Position, Range } from "./mapping";
import { type Symbol, SYMBOLS, symbolsToCode } from "./symbols";
import { toCodeTokens } from "./tokens";

/** A view and its file, by URI. */
export interface Target {
  code: string;
  file: string;
  mapping: Mapping;
}

type Json = unknown;
type JsonObject = Record<string, Json>;

/** Properties that only the server reads, or that refer to files. */
const OPAQUE = new Set(["data", "command", "edit", "changes", "documentChanges", "legend"]);

/** Converts the parameters of a request about the view to parameters about its file. */
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

/** Converts the response about the file for the view. Ranges outside the code are omitted. */
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
    // A call from another file, with ranges in that file.
    return value;
  }
  return toCodeObject(value, target);
}

/**
 * Converts an object. If its range is outside the code, the object is removed; if the range of a nested object (a
 * parent) is outside, only the property is.
 */
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

/**
 * Converts a location in the code to a location in the view. Other locations, in this file or elsewhere, remain
 * locations in files.
 */
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

/**
 * Command that applies a completion's edits outside the code, for example a new local, and then runs the completion's
 * own command.
 */
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
