// Projects by URI, their items, and the references between them.

import type { TreeProgram, TreeProject, TreeReference } from "../serverRequests";

/** Properties that all items of a project have. */
export type Item = Pick<TreeProgram, "name" | "detail" | "location" | "range">;

export class Graph {
  private readonly byUri: Map<string, TreeProject>;

  constructor(readonly projects: readonly TreeProject[]) {
    this.byUri = new Map(projects.map((project) => [project.uri, project]));
  }

  find(uri: string | null): TreeProject | undefined {
    return uri === null ? undefined : this.byUri.get(uri);
  }

  /** Returns the projects to which an entry refers: the declared project, and replacements that programs load. */
  targets({ project, loaded }: TreeReference): TreeProject[] {
    return [project, ...loaded].map((uri) => this.find(uri)).filter((found) => found !== undefined);
  }

  /** Returns the URIs of these projects and of all projects that they use. */
  reachable(from: readonly TreeProject[]): Set<string> {
    const found = new Set<string>();
    const next = [...from];
    for (let project = next.pop(); project !== undefined; project = next.pop()) {
      if (!found.has(project.uri)) {
        found.add(project.uri);
        next.push(...[...project.libraries, ...project.types].flatMap((entry) => this.targets(entry)));
      }
    }
    return found;
  }
}
