// Inputs and outputs as items of the view *Robot*.

import * as vscode from "vscode";
import type { DebuggedRun, Signal } from "../run";
import { levelFrom } from "./input";
import type { Item } from "./items";

const BY_NUMBER = new Intl.Collator("en", { numeric: true });

/** Groups the signals by board. The last part of a link is the signal's address on its board. */
export function boardItems(signals: readonly Signal[]): Item[] {
  const boardOf = ({ link }: Signal): string => link.slice(0, Math.max(link.lastIndexOf("\\"), 0));
  const boards = [...new Set(signals.map(boardOf))].sort((left, right) => BY_NUMBER.compare(left, right));
  return boards.map((board) => {
    const own = signals.filter((signal) => boardOf(signal) === board);
    const item = new vscode.TreeItem(board || "Other", vscode.TreeItemCollapsibleState.Collapsed);
    item.id = `board:${board}`;
    item.iconPath = new vscode.ThemeIcon("circuit-board");
    item.description = marksOfBoard(own);
    const sorted = own.toSorted((left, right) => BY_NUMBER.compare(left.link, right.link));
    return { item, children: sorted.map(signalItem) };
  });
}

function marksOfBoard(signals: readonly Signal[]): string {
  const locked = signals.filter(({ isLocked }) => isLocked).length;
  const simulated = signals.filter(({ isSimulated }) => isSimulated).length;
  return [
    `${signals.length} ${signals.length === 1 ? "signal" : "signals"}`,
    ...(locked > 0 ? [`${locked} locked`] : []),
    ...(simulated > 0 ? [`${simulated} simulated`] : []),
  ].join(", ");
}

function signalItem(signal: Signal): Item {
  const { link, direction, isDigital, isLocked, isSimulated, isProtected, fault } = signal;
  const marks = [
    ...(isLocked ? ["locked"] : []),
    ...(isSimulated ? ["simulated"] : []),
    ...(isProtected ? ["protected"] : []),
    ...(fault === null ? [] : [`fault: ${fault}`]),
  ];
  const address = link.slice(link.lastIndexOf("\\") + 1);
  const item = new vscode.TreeItem(address);
  item.id = `signal:${link}`;
  item.iconPath = icon(signal);
  item.description = [levelOf(signal), ...marks].join(", ");
  item.tooltip = `${link}: ${[direction, isDigital ? "digital" : "analog", ...marks].join(", ")}`;
  item.accessibilityInformation = { label: `${address} ${item.description}` };
  item.contextValue = ["signal", isDigital ? "digital" : "analog", isLocked ? "locked" : "free", isSimulated ? "simulated" : "real"].join(" ");
  return { item, signal, children: [] };
}

function levelOf({ value, isDigital }: Signal): string {
  return isDigital ? String(value !== 0) : String(Number(value.toFixed(3)));
}

function icon({ isDigital, value, isLocked, fault }: Signal): vscode.ThemeIcon {
  const isOn = value !== 0;
  const colour = fault !== null ? "errorForeground" : isLocked ? "charts.orange" : isDigital && isOn ? "charts.green" : undefined;
  const name = fault !== null ? "error" : isDigital ? (isOn ? "circle-filled" : "circle-outline") : "pulse";
  return new vscode.ThemeIcon(name, colour === undefined ? undefined : new vscode.ThemeColor(colour));
}

/** Registers the commands on a signal in the view. */
export function registerSignals(run: DebuggedRun): vscode.Disposable[] {
  const command = (name: string, args: (signal: Signal) => object | Promise<object | undefined>): vscode.Disposable =>
    vscode.commands.registerCommand(`val3.signal.${name}`, async (item?: Item) => {
      const signal = item?.signal;
      const change = signal && (await args(signal));
      if (signal !== undefined && change !== undefined) {
        await run.change("val3/ioForce", { link: signal.link, ...change });
      }
    });
  return [
    command("toggle", ({ value, isLocked }) => withLevel(value === 0, isLocked)),
    command("set", askLevel),
    command("lock", () => ({ lock: true })),
    command("unlock", () => ({ lock: false })),
    command("simulate", () => ({ simulate: true })),
    command("endSimulation", () => ({ simulate: false })),
  ];
}

/** Returns the arguments that set a value. A locked signal accepts a value only with a lock request. */
function withLevel(value: boolean | number, isLocked: boolean): object {
  return isLocked ? { lock: true, value } : { value };
}

async function askLevel({ link, value, isDigital, isLocked }: Signal): Promise<object | undefined> {
  const text = await vscode.window.showInputBox({
    prompt: `The value of ${link}`,
    value: String(isDigital ? value !== 0 : value),
    validateInput: (text) => (levelFrom(text, isDigital) === undefined ? `Write ${isDigital ? "true or false" : "a number"}.` : undefined),
  });
  const level = text === undefined ? undefined : levelFrom(text, isDigital);
  return level === undefined ? undefined : withLevel(level, isLocked);
}
