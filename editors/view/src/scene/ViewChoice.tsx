// Buttons of the views, which a narrow picture has in a menu.

import type { JSX } from "preact";
import { type ViewName, VIEWS } from "./Camera";
import { Menu } from "./Menu";

export function ViewChoice({ onChoose }: { onChoose: (name: ViewName) => void }): JSX.Element {
  const buttons = (Object.keys(VIEWS) as ViewName[]).map((name) => (
    <button key={name} type="button" title={name === "Iso" ? "Perspective from the front" : "Parallel projection along an axis"} onClick={() => onChoose(name)}>{name}</button>
  ));
  return <><span class="views">{buttons}</span><Menu label="View" className="view-menu">{buttons}</Menu></>;
}
