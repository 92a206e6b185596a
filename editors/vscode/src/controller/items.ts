// Items of the view "Controller", computed from the projects and their last comparisons. Pure functions.

import type { Icon } from "../tree/icons";
import type { ItemContent } from "../tree/nodes";
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

/** State of a file or an application: a side, both sides with different files, or no difference. */
type State = Side | "both" | "none";

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
  const id = project.folder;
  const serial = project.serial === "" ? "no serial number" : project.serial;
  const description = `${serial}, ${compared === undefined ? "not compared" : summary(compared)}`;
  return {
    ...common(project, id, project.address, { id: "server-environment" }),
    description,
    tooltip: `Controller ${project.address}\nSerial number: ${serial}\nFolder: ${folder}`,
    spoken: `${project.address}, controller, ${description}`,
    context: ["controller"],
    isOpen: true,
    children: compared === undefined ? undefined : () => children(project, compared),
  };
}

function summary({ applications, settings, time }: Compared): string {
  const files = [...applications.flatMap(({ files }) => files), ...settings];
  return `${files.length === 0 ? "no difference" : counted(files.length)} at ${time}`;
}

function children(project: Project, { applications, settings }: Compared): ControllerNode[] {
  const nodes = applications.map(({ name, files }) => ({
    ...groupNode(project, name, files, `${APPLICATIONS}${name}/`),
    application: name,
    context: ["application", ...(files.some(({ side }) => side !== "controller") ? ["changed"] : [])],
  }));
  const others = settings.length === 0 ? [] : [groupNode(project, "Settings", settings, "")];
  return [...nodes, ...others];
}

/** Returns an item with its differing files, whose labels are relative to `folder`. */
function groupNode(project: Project, label: string, files: readonly DifferingFile[], folder: string): ControllerNode {
  const state = stateOf(files);
  const description = state === "none" ? PLACES.none : `${PLACES[state]}, ${counted(files.length)}`;
  const id = `${project.folder}#${label}`;
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
  const { path, side, change } = file;
  const label = path.startsWith(folder) ? path.slice(folder.length) : path;
  const place = { local: `${change} here`, controller: `${change} on the controller`, conflict: "changed on both sides" }[side];
  return {
    ...common(project, `${project.folder}#${path}`, label, ICONS[side]),
    description: place,
    tooltip: `${path}: ${place}`,
    spoken: `${label}, ${place}`,
    context: ["file", ...(isLocal(file) ? ["local"] : [])],
    file,
    isOpen: false,
    children: undefined,
  };
}

function common(project: Project, id: string, label: string, icon: Icon) {
  return { id, label, icon, project, application: undefined, file: undefined, target: undefined };
}

/** Whether the local file exists, unless it was removed since the comparison. */
export function isLocal({ side, change }: DifferingFile): boolean {
  return side === "controller" ? change !== "added" : change !== "removed";
}

/** Whether the file exists on the controller, unless it was removed since the comparison. */
export function isOnController({ side, change }: DifferingFile): boolean {
  return side === "local" ? change !== "added" : side === "conflict" || change !== "removed";
}

function stateOf(files: readonly DifferingFile[]): State {
  const sides = new Set(files.map(({ side }) => side));
  const [side = "none"] = sides;
  return sides.has("conflict") ? "conflict" : sides.size > 1 ? "both" : side;
}

export function counted(files: number): string {
  return files === 1 ? "1 file" : `${files} files`;
}
