// Nodes of the view "VAL 3", computed from the projects that the server lists.

import type { Location } from "vscode-languageclient/node";
import type { TreeData, TreeProgram, TreeProject, TreeReference } from "../serverRequests";
import { Filter } from "./filter";
import { Graph, type Item } from "./graph";
import { dataIcon, GROUP, type Icon, MISSING, programIcon, projectIcon } from "./icons";
import { dataTexts, missingTexts, programTexts, projectTexts, referenceTexts, type Texts } from "./texts";

/** Shown part of a node, in this view and in the view "Controller". */
export interface ItemContent extends Texts {
  /** Constant while the node exists, so that it stays open and selected. */
  id: string;
  label: string;
  icon: Icon;
  /** Words by which menus select their entries. */
  context: string[];
  /** Location that a click opens. */
  target: Location | undefined;
  isOpen: boolean;
  /** `undefined` for a node without children. */
  children: (() => ItemContent[]) | undefined;
}

/** Node of the view. */
export interface TreeNode extends ItemContent {
  /** Project file for additions. */
  project: TreeProject | undefined;
  /** Item for rename, delete and find uses. */
  item: Item | undefined;
  children: (() => TreeNode[]) | undefined;
}

/** Number of data in a project above which they are grouped by type. */
const MANY = 40;
/** Depth of nested libraries that are open while a filter is set. */
const OPEN_DEPTH = 1;

const byName = new Intl.Collator(undefined, { numeric: true, sensitivity: "base" }).compare;

const sorted = <T extends { name: string }>(items: readonly T[]): T[] => [...items].sort((left, right) => byName(left.name, right.name));

const FILE_START = { start: { line: 0, character: 0 }, end: { line: 0, character: 0 } };

/** Branch of the tree: its project, and the projects that enclose it. */
interface Branch {
  id: string;
  project: TreeProject;
  around: string[];
  /** Whether all items are shown, because only the name of the project matches the filter. */
  isWhole: boolean;
}

export class TreeModel {
  private readonly graph: Graph;
  private readonly filter: Filter;

  constructor(projects: readonly TreeProject[], private readonly text: string, private readonly folderOf: (uri: string) => string) {
    this.graph = new Graph(projects);
    this.filter = new Filter(text, this.graph);
  }

  /** Returns the number of items that match the filter. */
  get count(): number {
    return this.filter.count;
  }

  /** Returns applications, then tests, then projects that neither uses. */
  roots(): TreeNode[] {
    const { projects } = this.graph;
    const ofKind = (kind: string): TreeProject[] => sorted(projects.filter((project) => project.kind === kind));
    const starting = [...ofKind("application"), ...ofKind("tests")];
    const used = this.graph.reachable(starting);
    const unused = [...ofKind("library"), ...ofKind("type")].filter(({ uri }) => !used.has(uri));
    const others = this.shown(unused, "other");
    return [...this.shown(starting, ""), ...(starting.length === 0 ? others : this.group("other", "Not Used by an Application", others))];
  }

  /** Returns the nodes of projects that pass the filter. */
  private shown(projects: readonly TreeProject[], place: string): TreeNode[] {
    const found = projects.filter((project) => this.filter.reaches(project));
    return found.map((project) => this.projectNode(project, this.id(`${place}:${project.uri}`), []));
  }

  /** Returns another id while a filter is set, so that VS Code shows the nodes open. */
  private id(id: string): string {
    return this.filter.isOn ? `${this.text}?${id}` : id;
  }

  private projectNode(project: TreeProject, id: string, around: string[]): TreeNode {
    const runs = project.programs.some(({ name }) => name === "start");
    const branch = this.branch(project, id, around);
    return {
      id,
      label: project.name,
      icon: projectIcon(project.kind),
      context: ["project", "file", ...(project.hasTypes ? ["hasTypes"] : []), ...(runs ? ["runs"] : [])],
      project,
      item: undefined,
      target: { uri: project.uri, range: FILE_START },
      isOpen: this.filter.isOn && !branch.isWhole,
      children: () => this.content(branch),
      ...projectTexts(project, this.folderOf(project.uri)),
    };
  }

  private branch(project: TreeProject, id: string, around: string[]): Branch {
    const branch = { id, project, around: [...around, project.uri], isWhole: false };
    return { ...branch, isWhole: this.filter.isOn && this.content(branch).length === 0 };
  }

  private content(branch: Branch): TreeNode[] {
    const { id, project } = branch;
    const programs = this.leaves(branch, project.programs, "programs", programNode);
    const data = this.leaves(branch, project.data, "data", dataNode);
    return [
      ...this.group(`${id}#programs`, "Programs", programs, ["programs"], project),
      ...this.group(`${id}#data`, "Data", data.length > MANY ? this.byType(`${id}#data`, data) : data, [], project, data.length),
      ...this.group(`${id}#libraries`, "Libraries", this.references(branch, "libraries"), ["libraries"], project),
      ...this.group(`${id}#types`, "Types", this.references(branch, "types"), ["types"], project),
    ];
  }

  private leaves<T extends Item>(branch: Branch, items: readonly T[], kind: string, node: (item: T) => Leaf): TreeNode[] {
    const wanted = branch.isWhole ? items : items.filter(({ name }) => this.filter.matches(name));
    const unique = uniqueIds(`${branch.id}#${kind}/`);
    return sorted(wanted).map((item) => ({
      ...node(item),
      id: unique(item.name),
      label: item.name,
      project: branch.project,
      item,
      target: item.location,
      isOpen: false,
      children: undefined,
    }));
  }

  private byType(id: string, nodes: TreeNode[]): TreeNode[] {
    const types = new Map<string, TreeNode[]>();
    for (const node of nodes) {
      const { type } = node.item as TreeData;
      types.set(type, [...(types.get(type) ?? []), node]);
    }
    const names = [...types.keys()].sort(byName);
    return names.flatMap((type) => {
      const [group] = this.group(`${id}:${type}`, type || "Without Type", types.get(type) ?? []);
      return group === undefined ? [] : [{ ...group, icon: dataIcon(type, true) }];
    });
  }

  private references(branch: Branch, kind: "libraries" | "types"): TreeNode[] {
    const isShown = (entry: TreeReference): boolean =>
      branch.isWhole || this.filter.matches(entry.name) || this.graph.targets(entry).some((project) => this.filter.reaches(project));
    const unique = uniqueIds(`${branch.id}#${kind}/`);
    const entries = branch.project[kind].filter(isShown);
    return sorted(entries).map((entry) => this.referenceNode(branch, entry, kind, unique(entry.name)));
  }

  private referenceNode({ project: owner, around }: Branch, entry: TreeReference, kind: "libraries" | "types", id: string): TreeNode {
    const project = this.graph.find(entry.project);
    const of = kind === "libraries" ? "library" : "type";
    const isInside = project === undefined || around.includes(project.uri);
    const loaded = (): TreeNode[] => this.loaded(entry, id, around);
    const content = (): TreeNode[] => (isInside ? [] : this.content(this.branch(project, id, around)));
    return {
      id,
      label: entry.name,
      icon: project === undefined ? MISSING : projectIcon(of),
      context: ["named", "file", ...(project === undefined ? [] : ["project", ...(project.hasTypes ? ["hasTypes"] : [])])],
      project: project ?? owner,
      item: entry,
      target: project === undefined ? entry.location : { uri: project.uri, range: FILE_START },
      isOpen: this.filter.isOn && around.length <= OPEN_DEPTH,
      children: isInside && entry.loaded.length === 0 ? undefined : () => [...content(), ...loaded()],
      ...(project === undefined ? missingTexts(entry, of) : referenceTexts(entry, of)),
    };
  }

  private loaded(entry: TreeReference, id: string, around: string[]): TreeNode[] {
    const projects = entry.loaded.map((uri) => this.graph.find(uri)).filter((found) => found !== undefined);
    const others = projects.filter((project) => !around.includes(project.uri) && this.filter.reaches(project));
    const nodes = sorted(others).map((project) => this.projectNode(project, `${id}#loaded:${project.uri}`, around));
    return this.group(`${id}#loaded`, "Loaded in Its Place", nodes);
  }

  /** Returns a list with the group; empty if the group has no nodes. */
  private group(id: string, label: string, nodes: TreeNode[], context: string[] = [], project?: TreeProject, count = nodes.length): TreeNode[] {
    if (nodes.length === 0) {
      return [];
    }
    const texts = { description: String(count), tooltip: label, spoken: `${label}, ${count}` };
    const common = { id, label, icon: GROUP, context, project, item: undefined, target: undefined };
    return [{ ...common, ...texts, isOpen: this.filter.isOn, children: () => nodes }];
  }
}

type Leaf = Texts & Pick<TreeNode, "icon" | "context">;

function programNode(program: TreeProgram): Leaf {
  const context = ["program", "named", "file", ...(program.runs ? ["runs"] : [])];
  return { icon: programIcon(program.public), context, ...programTexts(program) };
}

function dataNode(data: TreeData): Leaf {
  return { icon: dataIcon(data.type, data.public), context: ["data", "named", "file"], ...dataTexts(data) };
}

/** Returns a function that creates ids for names. If a name is declared twice, the ids differ. */
function uniqueIds(start: string): (name: string) => string {
  const seen = new Map<string, number>();
  return (name) => {
    const count = (seen.get(name) ?? 0) + 1;
    seen.set(name, count);
    return start + (count === 1 ? name : `${name}*${count}`);
  };
}
