// Failures as messages at their lines.

import { resolve } from "node:path";
import * as vscode from "vscode";
import { type Failure, type Place, placeOf, sides } from "./results";

/** Returns the message of a failure, whose paths are relative to `folder`. */
export function messageOf(failure: Failure, folder: string): vscode.TestMessage {
  const values = sides(failure.message);
  const message = values === undefined
    ? new vscode.TestMessage(failure.message)
    : vscode.TestMessage.diff(failure.message, values.expected, values.actual);
  const place = placeOf(failure);
  message.location = place && location(place, folder);
  message.stackTrace = failure.places.map((place) => {
    const { uri, range } = location(place, folder);
    return new vscode.TestMessageStackFrame(`${place.program}()`, place.file === "" ? undefined : uri, range.start);
  });
  return message;
}

function location({ file, line }: Place, folder: string): vscode.Location {
  return new vscode.Location(vscode.Uri.file(resolve(folder, file)), new vscode.Position(line - 1, 0));
}
