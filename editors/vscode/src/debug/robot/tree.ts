// The view *Robot* in the debug sidebar: the arm, its moves, the tasks, inputs and outputs.

import type { DebugProtocol as Protocol } from "@vscode/debugprotocol";
import * as vscode from "vscode";
import type { DebuggedRun, MotionMode, Move, Sample, Source } from "../run";
import { type Item, merge } from "./items";
import { boardItems } from "./signals";

const AXES = ["x", "y", "z", "rx", "ry", "rz"];

export class RobotTree implements vscode.TreeDataProvider<Item>, vscode.Disposable {
  private readonly changes = new vscode.EventEmitter<Item[] | undefined>();
  readonly onDidChangeTreeData = this.changes.event;
  private readonly subscription: vscode.Disposable;
  private readonly root: Item = { item: new vscode.TreeItem("Robot"), children: [] };
  private isUpdating = false;
  private isStale = false;

  constructor(private readonly run: DebuggedRun, report: (fault: unknown) => void) {
    this.subscription = run.onDidChange(() => void this.update().catch(report));
  }

  dispose(): void {
    this.subscription.dispose();
    this.changes.dispose();
  }

  getTreeItem({ item }: Item): vscode.TreeItem {
    return item;
  }

  getChildren(parent = this.root): Item[] {
    return parent.children;
  }

  /** Updates only the changed items, so that the other items can still be clicked. */
  private async update(): Promise<void> {
    this.isStale = true;
    if (this.isUpdating) {
      return;
    }
    this.isUpdating = true;
    try {
      while (this.isStale) {
        this.isStale = false;
        const changed = merge(this.root, { ...this.root, children: await this.groups() });
        if (changed.length > 0) {
          this.changes.fire(changed.includes(this.root) ? undefined : changed);
        }
      }
    } finally {
      this.isUpdating = false;
    }
  }

  private async groups(): Promise<Item[]> {
    const [arm, mode, queue, tasks, io] = await Promise.all([
      this.run.request("val3/pose", {}),
      this.run.request("val3/motionMode", {}),
      this.run.request("val3/motionQueue", {}),
      this.run.request("threads", {}),
      this.run.request("val3/io", {}),
    ]);
    if (arm === undefined || queue === undefined || tasks === undefined || io === undefined) {
      return [];
    }
    return [
      group("Arm", "move", armState(arm, mode?.mode), armItems(arm), true),
      group("Motion queue", "list-ordered", String(queue.moves.length), queue.moves.map(moveItem), true),
      group("Tasks", "server-process", String(tasks.threads.length), tasks.threads.map(taskItem), false),
      group("Inputs and outputs", "plug", String(io.signals.length), boardItems(io.signals), false),
    ];
  }
}

function group(label: string, icon: string, description: string, children: Item[], isOpen: boolean): Item {
  const { Expanded, Collapsed } = vscode.TreeItemCollapsibleState;
  const item = new vscode.TreeItem(label, isOpen ? Expanded : Collapsed);
  item.id = `group:${label}`;
  item.iconPath = new vscode.ThemeIcon(icon);
  item.description = description;
  return { item, children };
}

function leaf(label: string, description: string, icon: string): Item {
  const item = new vscode.TreeItem(label);
  item.description = description;
  item.iconPath = new vscode.ThemeIcon(icon);
  return { item, children: [] };
}

function armState({ phase, speed }: Sample, mode: MotionMode | undefined): string {
  const moving = speed > 0 ? `${phase}, ${speed.toFixed(0)} mm/s` : phase;
  return mode === "step" ? `${moving}, step by step` : moving;
}

function armItems({ pose, joints, source }: Sample): Item[] {
  const coordinates = (from: number): string => AXES.slice(from, from + 3).map((axis, index) => `${axis} ${fixed(pose[from + index])}`).join("  ");
  const moving = source === null ? [] : [atSource(leaf("move", place(source), "arrow-right"), source)];
  return [
    leaf("position", `${coordinates(0)} mm`, "location"),
    leaf("orientation", `${coordinates(3)}°`, "compass"),
    leaf("joints", joints.map(fixed).join("  "), "settings"),
    ...moving,
  ];
}

function moveItem(move: Move): Item {
  const { id, type, phase, source, mdesc, leave, reach, target } = move;
  const item = leaf(`${type ?? "move"} ${id}`, source === null ? phase : `${phase}, ${place(source)}`, phase === "waiting" ? "debug-pause" : "arrow-right");
  const corner = (name: string, distance: number | undefined): string[] => (distance === undefined ? [] : [`${name} ${fixed(distance)} mm from the target`]);
  item.item.tooltip = [
    `target ${AXES.map((axis, index) => `${axis} ${fixed(target[index])}`).join("  ")}`,
    ...(mdesc === null ? [] : [`vel ${mdesc.vel} %, blend ${mdesc.blend}`]),
    ...corner("leaves", leave?.distance),
    ...corner("reaches", reach?.distance),
  ].join("\n");
  return source === null ? item : atSource(item, source);
}

function taskItem({ name }: Protocol.Thread): Item {
  const [, task = name, state = ""] = /^(.*?) \((.*)\)$/.exec(name) ?? [];
  return leaf(task, state, "gear");
}

/** Opens the line when the item is clicked. */
function atSource(item: Item, source: Source): Item {
  item.item.command = { command: "val3.openLine", title: "Open", arguments: [source] };
  return item;
}

function place({ program, line }: Source): string {
  return `${program}.pgx:${line}`;
}

function fixed(number: number | undefined): string {
  return (number ?? 0).toFixed(1);
}
