// Names that match a text in any letter case, and the projects that contain such a name or reach one through references.

import type { TreeProject } from "../serverRequests";
import type { Graph, Item } from "./graph";

export class Filter {
  private readonly text: string;
  /** URIs of projects with a matching item. */
  private readonly own: Set<string>;
  private readonly reaching = new Map<string, boolean>();
  /** Number of matching items. */
  readonly count: number;

  constructor(text: string, private readonly graph: Graph) {
    this.text = text.toLowerCase();
    const counts = graph.projects.map((project) => [project.uri, this.countIn(project)] as const);
    this.own = new Set(counts.filter(([, count]) => count > 0).map(([uri]) => uri));
    this.count = counts.reduce((sum, [, count]) => sum + count, 0);
  }

  get isOn(): boolean {
    return this.text !== "";
  }

  matches(name: string): boolean {
    return name.toLowerCase().includes(this.text);
  }

  /** Whether the project contains a matching item, or reaches a project that does. */
  reaches(project: TreeProject): boolean {
    let known = this.reaching.get(project.uri);
    if (known === undefined) {
      known = [...this.graph.reachable([project])].some((uri) => this.own.has(uri));
      this.reaching.set(project.uri, known);
    }
    return known;
  }

  private countIn({ name, programs, data, libraries, types }: TreeProject): number {
    const items: (readonly Item[])[] = [programs, data, libraries, types];
    const matching = items.flat().filter((item) => this.matches(item.name)).length;
    return matching + Number(this.matches(name));
  }
}
