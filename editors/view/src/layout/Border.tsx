// Border between the picture and the panels, which the pointer and the arrow keys move.

import type { JSX, TargetedKeyboardEvent, TargetedPointerEvent } from "preact";
import { useEffect, useState } from "preact/hooks";
import { LEAST, MOST, movedShare, setShare, share, type Side, TALL } from "./layout";

export function Border(): JSX.Element {
  const side = useSide();
  const chosen = share(side);
  const [percent, setPercent] = useState(40);
  const [handle, setHandle] = useState<HTMLDivElement | null>(null);
  useEffect(() => {
    if (handle !== null) {
      setPercent(Math.round(shareOf(handle, side)));
    }
  }, [handle, side, chosen]);
  const drag = (event: TargetedPointerEvent<HTMLDivElement>): void => {
    const { currentTarget, pointerId, clientX, clientY } = event;
    const box = currentTarget.parentElement?.getBoundingClientRect();
    if (box !== undefined && currentTarget.hasPointerCapture(pointerId)) {
      setShare(side, side === "beside" ? ((box.right - clientX) / box.width) * 100 : ((box.bottom - clientY) / box.height) * 100);
    }
  };
  const press = (event: TargetedKeyboardEvent<HTMLDivElement>): void => {
    const moved = movedShare(event.key, side, shareOf(event.currentTarget, side));
    if (moved !== undefined) {
      event.preventDefault();
      event.stopPropagation();
      setShare(side, moved);
    }
  };
  return (
    <div
      class="border" role="separator" tabIndex={0} ref={setHandle} title="Drag to resize; double-click restores the size"
      aria-label="Size of the panels" aria-orientation={side === "beside" ? "vertical" : "horizontal"} aria-valuemin={LEAST} aria-valuemax={MOST} aria-valuenow={percent}
      onPointerDown={(event) => { event.preventDefault(); event.currentTarget.setPointerCapture(event.pointerId); }}
      onPointerMove={drag} onKeyDown={press} onDblClick={() => setShare(side, undefined)}
    />
  );
}

/** Returns the present share of the panels in per cent, also where the style sheet determines it. */
function shareOf(handle: HTMLElement, side: Side): number {
  const [panels, whole] = [handle.nextElementSibling?.getBoundingClientRect(), handle.parentElement?.getBoundingClientRect()];
  if (panels === undefined || whole === undefined) {
    return 0;
  }
  return side === "beside" ? (panels.width / Math.max(whole.width, 1)) * 100 : (panels.height / Math.max(whole.height, 1)) * 100;
}

function useSide(): Side {
  const [query] = useState(() => matchMedia(TALL));
  const [isTall, setTall] = useState(query.matches);
  useEffect(() => {
    const change = (): void => setTall(query.matches);
    query.addEventListener("change", change);
    return () => query.removeEventListener("change", change);
  }, [query]);
  return isTall ? "below" : "beside";
}
