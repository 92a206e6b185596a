// Visible rows of a scrolled box, and the box itself.

import type { RefObject, TargetedEvent } from "preact";
import { useEffect, useRef, useState } from "preact/hooks";
import { type VisibleRows, visibleRows } from "./visibleRows";

export interface ScrolledRows extends VisibleRows {
  box: RefObject<HTMLDivElement | null>;
  onScroll: (event: TargetedEvent<HTMLDivElement>) => void;
}

/** Draws again only when other rows become visible. */
export function useVisibleRows(count: number, rowHeight: number): ScrolledRows {
  const box = useRef<HTMLDivElement>(null);
  const [view, setView] = useState({ top: 0, height: 400 });
  const { first, end } = visibleRows(count, rowHeight, view.top, view.height);
  useEffect(() => {
    const element = box.current;
    if (element === null) {
      return undefined;
    }
    const observer = new ResizeObserver(() => setView({ top: element.scrollTop, height: element.clientHeight }));
    observer.observe(element);
    return () => observer.disconnect();
  }, []);
  const onScroll = ({ currentTarget: { scrollTop, clientHeight } }: TargetedEvent<HTMLDivElement>): void => {
    if (visibleRows(count, rowHeight, scrollTop, clientHeight).first !== first) {
      setView({ top: scrollTop, height: clientHeight });
    }
  };
  return { box, first, end, onScroll };
}
