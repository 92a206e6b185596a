// Icons of the view: one for each kind of item. Items that other projects can use have a colour.

import type { ProjectKind } from "../serverRequests";

export interface Icon {
  /** Name of a codicon. */
  id: string;
  /** Identifier of a theme colour. */
  color?: string;
}

const BLUE = "charts.blue";
const GREEN = "charts.green";
const ORANGE = "charts.orange";
const PURPLE = "charts.purple";
const RED = "charts.red";
const YELLOW = "charts.yellow";

const PROJECTS: Record<ProjectKind, Icon> = {
  application: { id: "robot", color: GREEN },
  tests: { id: "beaker", color: YELLOW },
  library: { id: "library", color: ORANGE },
  type: { id: "symbol-structure", color: PURPLE },
};

/** Icons by type; types in files may have the kind of arm as suffix. */
const DATA: Record<string, Required<Icon>> = {
  num: { id: "symbol-number", color: BLUE },
  bool: { id: "symbol-boolean", color: BLUE },
  string: { id: "symbol-string", color: BLUE },
  dio: { id: "plug", color: ORANGE },
  aio: { id: "pulse", color: ORANGE },
  sio: { id: "radio-tower", color: ORANGE },
  point: { id: "location", color: RED },
  joint: { id: "git-commit", color: RED },
  trsf: { id: "move", color: RED },
  config: { id: "settings", color: RED },
  frame: { id: "compass", color: GREEN },
  tool: { id: "tools", color: GREEN },
  mdesc: { id: "dashboard", color: YELLOW },
  screen: { id: "device-desktop", color: YELLOW },
};

const USER_TYPE: Required<Icon> = { id: "symbol-structure", color: PURPLE };

/** Icon for a group of items. */
export const GROUP: Icon = { id: "folder" };

/** Icon of a library or type whose project does not exist. */
export const MISSING: Icon = { id: "warning", color: "list.warningForeground" };

export function projectIcon(kind: ProjectKind): Icon {
  return PROJECTS[kind];
}

export function programIcon(isPublic: boolean): Icon {
  return withAccess({ id: "symbol-method", color: PURPLE }, isPublic);
}

export function dataIcon(type: string, isPublic: boolean): Icon {
  return withAccess(DATA[type.replace(/R[xs]$|Vrb$/, "")] ?? USER_TYPE, isPublic);
}

/** Private items have the colour of other icons, because symbols would have a separate colour. */
function withAccess({ id, color }: Required<Icon>, isPublic: boolean): Icon {
  return { id, color: isPublic ? color : "icon.foreground" };
}
