// Items of the view "Controller", computed from the projects and their last comparisons. Pure functions.

import type { Icon } from "../tree/icons";
import type { ItemContent } from "../tree/nodes";
import { serverOf } from "./address";
import type { Comparison, DifferingFile, Side } from "./answers";
import type { Project } from "./projects";

/** Last comparison of a project with its controller. */
export interface Compared extends Comparison {
  /** Local time, such as `14:32`. */
  time: string;
}

export interface ControllerNode extends ItemContent {
  project: Project;
  /** Application of the node. */
  application: string | undefined;
  /** File of the node. */
  file: DifferingFile | undefined;
  children: (() => ControllerNode[]) | undefined;
}

/** Folder of the applications on a controller. */
const APPLICATIONS = "usr/usrapp/";

type Difference = DifferingFile & { side: Exclude<Side, "alike"> };

/** State of an application: a side, both sides with different files, or no difference. */
type State = Difference["side"] | "both" | "none";

const ICONS: Record<State, Icon> = {
  local: { id: "arrow-up", color: "charts.blue" },
  controller: { id: "arrow-down", color: "charts.purple" },
  both: { id: "arrow-swap", color: "charts.orange" },
  conflict: { id: "warning", color: "list.errorForeground" },
  none: { id: "pass", color: "charts.green" },
};

const PLACES: Record<State, string> = {
  local: "changed here",
  controller: "changed on the controller",
  both: "changed here and on the controller",
  conflict: "conflict",
  none: "unchanged",
};

/** Returns the item of a project. `compared` is `undefined` before the first comparison. */
export function projectNode(project: Project, folder: string, compared: Compared | undefined): ControllerNode {
  const id = idOf(project.folder, compared !== undefined);
  const serial = project.serial === "" ? "no serial number" : project.serial;
  const description = `${serial}, ${compared === undefined ? "not compared" : summary(compared)}`;
  return {
    ...common(project, id, shortAddress(project.address), { id: "server-environment" }),
    description,
    tooltip: `Controller ${project.address}\nSerial number: ${serial}\nFolder: ${folder}`,
    spoken: `${project.address}, controller, ${description}`,
    context: ["controller"],
    isOpen: true,
    children: compared === undefined ? undefined : () => children(project, compared),
  };
}

/** Returns the host of a server, or the name of an emulator's folder, because the view is narrow. */
function shortAddress(address: string): string {
  return serverOf(address)?.host ?? address.split(/[\\/]/).findLast((name) => name !== "") ?? address;
}

function summary({ applications, settings, time }: Compared): string {
  const files = differing([...applications.flatMap(({ files }) => files), ...settings]);
  return `${files.length === 0 ? "no difference" : `${counted(files.length)} changed`} at ${time}`;
}

function children(project: Project, { applications, settings }: Compared): ControllerNode[] {
  const nodes = applications.map(({ name, files }) => ({
    ...groupNode(project, name, files, `${APPLICATIONS}${name}/`),
    application: name,
    context: ["application", ...(files.some(({ side }) => side === "local" || side === "conflict") ? ["changed"] : [])],
  }));
  const others = settings.length === 0 ? [] : [groupNode(project, "Settings", settings, "")];
  return [...nodes, ...others];
}

/** Returns an item with its differing files, whose labels are relative to `folder`. */
function groupNode(project: Project, label: string, files: readonly DifferingFile[], folder: string): ControllerNode {
  const state = stateOf(files);
  const description = state === "none" ? PLACES.none : `${PLACES[state]}, ${counted(differing(files).length)}`;
  const id = idOf(`${project.folder}#${label}`, files.length > 0);
  return {
    ...common(project, id, label, ICONS[state]),
    description,
    tooltip: `${label}: ${description}`,
    spoken: `${label}, ${folder === "" ? "" : "application, "}${description}`,
    context: [],
    isOpen: true,
    children: files.length === 0 ? undefined : () => files.map((file) => fileNode(project, file, folder)),
  };
}

function fileNode(project: Project, file: DifferingFile, folder: string): ControllerNode {
  const { path, side } = file;
  const label = path.startsWith(folder) ? path.slice(folder.length) : path;
  const place = placeOf(file);
  return {
    ...common(project, `${project.folder}#${path}`, label, ICONS[side === "alike" ? "none" : side]),
    description: place,
    tooltip: `${path}: ${place}`,
    spoken: `${label}, ${place}`,
    context: ["file", ...(isLocal(file) ? ["local"] : [])],
    file,
    isOpen: false,
    children: undefined,
  };
}

/** Returns different ids with and without children. VS Code would show children of an item that had none closed. */
function idOf(id: string, hasChildren: boolean): string {
  return hasChildren ? `${id}/` : id;
}

function placeOf({ side, change, controller_change: other = change }: DifferingFile): string {
  const places: Record<Side, string> = {
    local: `${change} here`,
    controller: `${change} on the controller`,
    conflict: change === other ? `${change} on both sides` : `${change} here, ${other} on the controller`,
    alike: "same change on both sides",
  };
  return places[side];
}

function common(project: Project, id: string, label: string, icon: Icon) {
  return { id, label, icon, project, application: undefined, file: undefined, target: undefined };
}

/** Whether the local file exists, unless it was removed since the comparison. */
export function isLocal({ side, change }: DifferingFile): boolean {
  return side === "controller" ? change !== "added" : change !== "removed";
}

/** Whether the file exists on the controller, unless it was removed since the comparison. */
export function isOnController({ side, change, controller_change: other = change }: DifferingFile): boolean {
  return side === "local" ? change !== "added" : other !== "removed";
}

/** Returns the files that are not alike on both sides. */
function differing(files: readonly DifferingFile[]): Difference[] {
  return files.filter((file): file is Difference => file.side !== "alike");
}

function stateOf(files: readonly DifferingFile[]): State {
  const sides = new Set(differing(files).map(({ side }) => side));
  const [side = "none"] = sides;
  return sides.has("conflict") ? "conflict" : sides.size > 1 ? "both" : side;
}

export function counted(files: number): string {
  return files === 1 ? "1 file" : `${files} files`;
}
