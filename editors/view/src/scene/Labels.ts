// Names over the drawing. Names that would cover more important names, buttons or figures are omitted.

import { Vector3 } from "three";
import { lengthText, type LengthUnit } from "../panels/shared/lengths";
import type { Lens } from "./Camera";
import { arrow, directionTo, placesTowards } from "./outside";
import { textWidth } from "./textWidth";

export interface Label {
  text: string;
  at: readonly number[];
  kind: "point" | "frame" | "tool" | "selected" | "measure" | "near" | "contact" | "failed";
  /** Distance from the tool centre point, in mm. A position outside the picture then has an arrow at the border. */
  away?: number;
}

type Box = readonly [left: number, top: number, right: number, bottom: number];

const ORDER = ["measure", "failed", "contact", "near", "selected", "tool", "frame", "point"];
const HEIGHT = 18;

/** Kinds of names in semibold, as in scene.css. */
const BOLD: readonly Label["kind"][] = ["tool", "selected", "measure", "near", "contact", "failed"];

/** Distance of a name from its position, in px. */
const GAP = 9;

/** Half size of the areas along the arm that names of points do not cover, in px. */
const AROUND = 12;

export class Labels {
  private readonly pool: HTMLElement[] = [];

  /** `parent` receives the labels. All siblings of `parent` except the drawing count as elements over the drawing. */
  constructor(private readonly parent: HTMLElement) {}

  /** Draws the labels. Names of points do not cover the arm at `obstacles`. */
  draw(labels: readonly Label[], obstacles: readonly (readonly number[])[], camera: Lens, canvas: HTMLElement, unit: LengthUnit): void {
    const [width, height] = [canvas.clientWidth, canvas.clientHeight];
    const taken = this.covered(canvas);
    const onScreen = ([x = 0, y = 0, z = 0]: readonly number[]): Vector3 => {
      const place = new Vector3(x, y, z).project(camera);
      return place.set((place.x + 1) * 0.5 * width, (1 - place.y) * 0.5 * height, place.z);
    };
    const arm = obstacles.map(onScreen).map(({ x, y }): Box => [x - AROUND, y - AROUND, x + AROUND, y + AROUND]);
    let count = 0;
    for (const label of labels.toSorted((a, b) => ORDER.indexOf(a.kind) - ORDER.indexOf(b.kind))) {
      const place = onScreen(label.at);
      const [across, down] = [Math.round(place.x), Math.round(place.y) - HEIGHT / 2];
      const avoided = label.kind === "point" ? [...taken, ...arm] : taken;
      const isOutside = place.z > 1 || place.x < 0 || place.y < 0 || place.x > width || place.y > height;
      const isFar = isOutside && label.away !== undefined;
      const direction = directionTo(label.at, camera);
      const text = isFar ? `${label.text}, ${lengthText(label.away ?? 0, 0, unit)} away ${arrow(direction)}` : label.text;
      const wide = textWidth(text, BOLD.includes(label.kind));
      const isFree = ([x, y]: readonly [number, number]): boolean => x >= 0 && y >= 0 && x + wide <= width && y + HEIGHT <= height
        && !avoided.some(([left, top, right, bottom]) => y < bottom && top < y + HEIGHT && x < right && left < x + wide);
      // Right of the position, left of it, above and below.
      const around = [[across + GAP, down], [across - GAP - wide, down], [across - wide / 2, down - HEIGHT], [across - wide / 2, down + HEIGHT]] as const;
      const free = (isFar ? placesTowards(direction, [width, height], [wide, HEIGHT]) : around).find(isFree);
      if ((isFar || place.z <= 1) && free !== undefined) {
        this.put(count, { ...label, text }, ...free);
        count += 1;
        taken.push([free[0], free[1], free[0] + wide, free[1] + HEIGHT]);
      }
    }
    this.pool.slice(count).forEach((element) => (element.hidden = true));
  }

  /** Returns the vertical extents of the elements over the drawing, in px. */
  bars(canvas: HTMLElement): { top: number; bottom: number }[] {
    return this.covered(canvas).map(([, top, , bottom]) => ({ top, bottom }));
  }

  /** Returns the areas of elements over the drawing, in its coordinates. */
  private covered(canvas: HTMLElement): Box[] {
    const { left, top } = canvas.getBoundingClientRect();
    const others = [...(this.parent.parentElement?.children ?? [])].filter((element) => element !== this.parent && element !== canvas)
      .flatMap((element) => (element.classList.contains("foot") ? [...element.children] : element));
    return others.map((element) => element.getBoundingClientRect()).filter(({ width }) => width > 0)
      .map((box) => [box.left - left, box.top - top, box.right - left, box.bottom - top]);
  }

  private put(index: number, { text, kind }: Label, x: number, y: number): void {
    let element = this.pool[index];
    if (element === undefined) {
      element = document.createElement("span");
      this.pool.push(element);
      this.parent.append(element);
    }
    element.hidden = false;
    element.className = `name ${kind}`;
    element.textContent = text;
    element.style.transform = `translate(${x}px, ${y}px)`;
  }
}
