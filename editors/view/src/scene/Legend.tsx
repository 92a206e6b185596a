// Legend of the colours that occur in the drawing.

import type { JSX } from "preact";
import { isDark } from "../look";
import { nearnessAt } from "../panels/clearance/encounters";
import { pointText } from "../panels/points/edits";
import type { Store } from "../store";
import { hiddenLayers } from "./layers";
import { spheresOf } from "./MotionMarks";
import { NEARNESS } from "./nearness";
import { CORNERS, css, DARK, LIGHT, phaseColour } from "./palette";
import type { Viewport } from "./Viewport";

const CORNER_NAMES = { leave: "leave distance", reach: "reach distance", both: "leave and reach distance" } as const;
const NEARNESS_NAMES = { near: "too near", contact: "touching" } as const;

interface Props {
  store: Store;
  view: Viewport | undefined;
  /** Tool of the drawn reach, if it is drawn. */
  reachOf: string | undefined;
}

export function Legend({ store, view, reachOf }: Props): JSX.Element | null {
  const { path, queue } = store.panels.cell.motion.value;
  const hidden = hiddenLayers.value;
  const hasAhead = path.length > 0 && !hidden.has("ahead");
  const travelled = hidden.has("path") ? [] : [...(view?.trail.occurring.value ?? [])].map((phase) => store.scene.value?.phases[phase]);
  const occurring = new Set([...travelled, ...(hasAhead ? path.map(({ phase }) => phase) : [])]);
  const phases = (store.scene.value?.phases ?? []).filter((phase) => phase !== "waiting" && occurring.has(phase));
  const corners = hidden.has("ahead") ? [] : [...new Set(spheresOf(queue).map(({ kind }) => kind))];
  const { points, unreachable } = store.panels.cell;
  const hasFar = !hidden.has("points") && points.value.some((point) => unreachable.value.reasons.has(pointText(point)));
  const nearness = new Set(nearnessAt(store.panels.cell.history.encounters.list, store.time.value).values());
  return phases.length + corners.length + nearness.size === 0 && !hasFar && reachOf === undefined ? null : (
    <ul class="legend" aria-label="Colours of the path">
      {phases.map((phase) => <li key={phase}><i style={{ background: css(phaseColour(phase)) }} />{phase}</li>)}
      {hasAhead ? <li><i class="dashed" />ahead</li> : null}
      {hasFar ? <li><i class="ball" style={{ background: css((isDark.value ? DARK : LIGHT).unreachable) }} />{`out of reach of ${unreachable.value.tool ?? "the last move's tool"}`}</li> : null}
      {reachOf === undefined ? null : <li><i class="ball area" />reach of {reachOf}</li>}
      {[...nearness].map((kind) => <li key={kind}><i class="ball" style={{ background: css(NEARNESS[kind]) }} />{NEARNESS_NAMES[kind]}</li>)}
      {corners.map((kind) => <li key={kind}><i class="ball" style={{ background: css(CORNERS[kind]) }} />{CORNER_NAMES[kind]}</li>)}
    </ul>
  );
}
