// State of the page: the tables, their shown part, and the active cell.

import { computed, type ReadonlySignal, signal, type Signal } from "@preact/signals";
import { contentOf } from "./cells";
import { type GridColumn, gridColumns } from "./columns";
import { Findings } from "./findings";
import { Notice } from "../panels/shared/cell";
import type { Host } from "./host";
import { elementOf, placeId } from "./place";
import { Poses } from "./poses";
import type { DataEdit, DataTables, DataType, Datum, EditAnswer } from "./protocol";
import { type Row, rowsAbove, rowsOf } from "./rows";
import { type Filter, matches, matchingKeys, wordsOf } from "./search";
import { type Rectangle, rectangleOf, type Selection } from "./selection";
import { type Order, sorted } from "./sorting";

/** Pseudo type of the table with all data. */
export const ALL = "";

export type Dialog = "add" | "duplicate" | "delete" | "addKey";

/** Cell that is being edited. */
export interface Editing {
  row: string;
  column: string;
  text: string;
}

export class DataModel {
  readonly tables = signal<DataTables | undefined>(undefined);
  readonly unavailable = signal("");
  readonly notice = new Notice();
  readonly shown = signal(ALL);
  readonly filter = signal<Filter>({ text: "", access: "all", isFaultyOnly: false });
  readonly order = signal<Order | undefined>(undefined);
  readonly expanded = signal<ReadonlySet<string>>(new Set());
  readonly selection: Signal<Selection | undefined> = signal(undefined);
  readonly editing: Signal<Editing | undefined> = signal(undefined);
  readonly dialog: Signal<Dialog | undefined> = signal(undefined);
  readonly poses = new Poses(() => this.host, (fault) => this.report(fault));
  host: Host | undefined;

  readonly types: ReadonlySignal<ReadonlyMap<string, DataType>> = computed(() => new Map((this.tables.value?.types ?? []).map((type) => [type.name, type])));
  readonly findings = computed(() => new Findings(this.tables.value?.findings));
  readonly shownType = computed(() => this.types.value.get(this.shown.value));
  /** Reason why nothing can be edited. */
  readonly blocked = computed(() => this.tables.value?.problem ?? undefined);
  private readonly found = computed(() => this.search());
  readonly columns: ReadonlySignal<readonly GridColumn[]> = computed(() => gridColumns(this.shownType.value, this.types.value, this.tables.value?.data ?? []));
  readonly rows: ReadonlySignal<readonly Row[]> = computed(() => this.makeRows());
  private readonly rowIndices = computed(() => new Map(this.rows.value.map(({ id }, index) => [id, index])));
  readonly rectangle: ReadonlySignal<Rectangle | undefined> = computed(() => this.makeRectangle());
  /** Number of data by type, total and matching. */
  readonly counts = computed(() => this.count());

  take(tables: DataTables): void {
    const isFirst = this.tables.peek() === undefined;
    const before = this.rectangle.peek();
    const editing = this.editing.peek();
    this.tables.value = tables;
    this.unavailable.value = "";
    if (isFirst) {
      this.shown.value = tables.data[0]?.type ?? ALL;
    } else if (before !== undefined && this.rectangle.peek() === undefined) {
      // The row was removed: another row is at its index now.
      const column = this.columns.peek().findIndex(({ id }) => id === this.selection.peek()?.active.column);
      this.select(Math.min(before.top, this.rows.peek().length - 1), Math.max(column, 0));
    }
    if (editing !== undefined && this.positionOf(editing) === undefined) {
      this.editing.value = undefined;
    }
    this.poses.forget();
  }

  /** Returns the indices of a cell. */
  positionOf({ row, column }: { row: string; column: string }): { row: number; column: number } | undefined {
    const at = { row: this.rowIndices.value.get(row), column: this.columns.value.findIndex(({ id }) => id === column) };
    return at.row === undefined || at.column < 0 ? undefined : { row: at.row, column: at.column };
  }

  /** Returns the row with the active cell. */
  activeRow(): Row | undefined {
    const { row } = this.selection.value?.active ?? {};
    return row === undefined ? undefined : this.rows.value[this.rowIndices.value.get(row) ?? -1];
  }

  activeColumn(): GridColumn | undefined {
    return this.columns.value.find(({ id }) => id === this.selection.value?.active.column);
  }

  /** Returns the rows of the selected rectangle. */
  selectedRows(): readonly Row[] {
    const rectangle = this.rectangle.value;
    return rectangle === undefined ? [] : this.rows.value.slice(rectangle.top, rectangle.bottom + 1);
  }

  /** Selects the cell at these indices; `isExtended` keeps the anchor. */
  select(row: number, column: number, isExtended = false): void {
    const to = this.rows.value[row];
    const at = this.columns.value[column];
    if (to !== undefined && at !== undefined) {
      const active = { row: to.id, column: at.id };
      this.selection.value = { active, anchor: isExtended ? (this.selection.peek()?.anchor ?? active) : active };
    }
  }

  toggle(id: string): void {
    const next = new Set(this.expanded.peek());
    if (!next.delete(id)) {
      next.add(id);
    }
    this.expanded.value = next;
  }

  /** Shows a datum or an element, regardless of filters. */
  reveal(name: string, key?: string): void {
    const datum = this.tables.peek()?.data.find((datum) => datum.name === name);
    if (datum === undefined) {
      this.notice.text.value = `The file has no data ${name}.`;
      return;
    }
    this.shown.value = datum.type;
    this.filter.value = { text: "", access: "all", isFaultyOnly: false };
    const place = key === undefined ? { name } : elementOf({ name }, key);
    this.expanded.value = new Set([...this.expanded.peek(), ...rowsAbove(place)]);
    const row = this.rowIndices.value.get(placeId(place)) ?? this.rowIndices.value.get(name) ?? 0;
    this.select(row, 0);
  }

  /** Applies edits. If they are rejected, the notice shows the reason. */
  async edit(edits: readonly DataEdit[]): Promise<boolean> {
    return edits.length === 0 || this.settle((host) => host.request("edit", { edits, check: false }));
  }

  async rename(name: string, as: string): Promise<boolean> {
    return this.settle((host) => host.request("rename", { name, as }));
  }

  /** Checks edits without applying them. */
  async check(edits: readonly DataEdit[]): Promise<EditAnswer> {
    return this.editor().request("edit", { edits, check: true });
  }

  report(fault: unknown): void {
    this.notice.text.value = messageOf(fault);
  }

  private async settle(work: (host: Host) => Promise<EditAnswer>): Promise<boolean> {
    const refused = this.blocked.peek() ?? (await work(this.editor()).then(({ refused }) => refused, messageOf));
    this.notice.text.value = refused ?? "";
    return refused === null;
  }

  private editor(): Host {
    if (this.host === undefined) {
      throw new Error("The tables are not connected to an editor.");
    }
    return this.host;
  }

  private search(): readonly Datum[] {
    const filter = this.filter.value;
    const findings = this.findings.value;
    return (this.tables.value?.data ?? []).filter((datum) => matches(datum, filter, (name) => findings.below(name).length > 0));
  }

  private makeRows(): readonly Row[] {
    const type = this.shown.value;
    const order = this.order.value;
    const data = type === ALL ? this.found.value : this.found.value.filter((datum) => datum.type === type);
    const column = this.columns.value.find(({ id }) => id === order?.column);
    const expanded = this.expanded.value;
    const { text } = this.filter.value;
    return rowsOf(sorted(data, column, order?.isDescending ?? false, this.types.value), {
      typeOf: (name) => this.types.value.get(name),
      isExpanded: (id) => expanded.has(id),
      ...(wordsOf(text).length > 0 && { shownKeys: (datum: Datum, _: unknown, keys: readonly string[]) => matchingKeys(datum, text, keys) }),
    });
  }

  private makeRectangle(): Rectangle | undefined {
    const selection = this.selection.value;
    const active = selection && this.positionOf(selection.active);
    return active && rectangleOf(active, this.positionOf(selection.anchor) ?? active);
  }

  private count(): Map<string, { all: number; found: number }> {
    const counts = new Map<string, { all: number; found: number }>();
    const add = (datum: Datum, field: "all" | "found"): void => {
      for (const type of [ALL, datum.type]) {
        const count = counts.get(type) ?? { all: 0, found: 0 };
        count[field] += 1;
        counts.set(type, count);
      }
    };
    this.tables.value?.data.forEach((datum) => add(datum, "all"));
    this.found.value.forEach((datum) => add(datum, "found"));
    return counts;
  }

  /** Returns the finding of the active cell, and its full text, for the line below the table. */
  activeText(): { text: string; title: string } {
    const [row, column] = [this.activeRow(), this.activeColumn()];
    if (row === undefined || column === undefined) {
      return { text: "", title: "" };
    }
    const content = contentOf(row, column);
    return { text: content.text, title: `${row.label} ${content.column?.title ?? column.title}`.trim() };
  }
}

function messageOf(fault: unknown): string {
  return fault instanceof Error ? fault.message : String(fault);
}
