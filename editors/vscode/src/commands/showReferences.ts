// Shows the references when the user clicks their number.

import * as vscode from "vscode";
import type { Location, Position } from "vscode-languageclient/node";

export const SHOW_REFERENCES = "val3.showReferences";

export function registerShowReferences(): vscode.Disposable[] {
  return [vscode.commands.registerCommand(SHOW_REFERENCES, showReferences)];
}

/** Converts arguments in the form of the protocol, which VS Code's own command does not accept. */
async function showReferences(uri: string, position: Position, places: Location[]): Promise<void> {
  const at = (place: Position): vscode.Position => new vscode.Position(place.line, place.character);
  const locations = places.map(({ uri, range }) => new vscode.Location(vscode.Uri.parse(uri), new vscode.Range(at(range.start), at(range.end))));
  await vscode.commands.executeCommand("editor.action.showReferences", vscode.Uri.parse(uri), at(position), locations);
}
