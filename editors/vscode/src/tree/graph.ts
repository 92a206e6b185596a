// Projects by URI, and the references between them.

import type { Project, Reference } from "./protocol";

export class Graph {
  private readonly byUri: Map<string, Project>;

  constructor(readonly projects: readonly Project[]) {
    this.byUri = new Map(projects.map((project) => [project.uri, project]));
  }

  find(uri: string | null): Project | undefined {
    return uri === null ? undefined : this.byUri.get(uri);
  }

  /** Returns the projects to which an entry refers: the declared one, and replacements that programs load. */
  targets({ project, loaded }: Reference): Project[] {
    return [project, ...loaded].map((uri) => this.find(uri)).filter((found) => found !== undefined);
  }

  /** Returns the URIs of these projects and of all projects that they use. */
  reachable(from: readonly Project[]): Set<string> {
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
