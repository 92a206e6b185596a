// The projects by their URIs, and the ways between them.

import type { Project, Reference } from "./protocol";

export class Graph {
  private readonly byUri: Map<string, Project>;

  constructor(readonly projects: readonly Project[]) {
    this.byUri = new Map(projects.map((project) => [project.uri, project]));
  }

  find(uri: string | null): Project | undefined {
    return uri === null ? undefined : this.byUri.get(uri);
  }

  /** The projects that an entry means: its own, and those that are loaded in its place. */
  targets({ project, loaded }: Reference): Project[] {
    return [project, ...loaded].map((uri) => this.find(uri)).filter((found) => found !== undefined);
  }

  /** The URIs of these projects, and of all that they use. */
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
