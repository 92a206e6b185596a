// Items of a tree that is updated in place.

import type * as vscode from "vscode";
import type { Signal } from "../run";

export interface Item {
  item: vscode.TreeItem;
  children: Item[];
  /** Signal, if the item is an input or output. */
  signal?: Signal;
}

/** Updates `old` to `fresh`, and returns the items that the view has to redraw with their children. */
export function merge(old: Item, fresh: Item): Item[] {
  const isSame = JSON.stringify(old.item) === JSON.stringify(fresh.item);
  const isSimilar = old.children.length === fresh.children.length
    && old.children.every((child, index) => identity(child) === identity(fresh.children[index]));
  old.item = fresh.item;
  old.signal = fresh.signal;
  if (!isSimilar) {
    old.children = fresh.children;
    return [old];
  }
  const changed = old.children.flatMap((child, index) => merge(child, fresh.children[index] ?? child));
  return isSame ? changed : [old];
}

function identity(item: Item | undefined): string {
  return JSON.stringify([item?.item.id, item?.item.label]);
}
