// Drawing of the cell. It is updated only after changes.

import { signal } from "@preact/signals";
import { Color, Group, PCFShadowMap, Scene, Vector3, WebGLRenderer } from "three";
import { armFrames, armLength, floorHeight } from "../kinematics";
import { remember, remembered } from "../memory";
import { storedView, viewKey } from "./storedView";
import { nearnessAt } from "../panels/clearance/encounters";
import { composed, type Frame, frameOf, IDENTITY } from "../panels/pendant/pose";
import { handTool } from "../panels/points/tools";
import { lengthText, unitOf } from "../panels/shared/lengths";
import type { Scene as Cell } from "../protocol";
import type { Store } from "../store";
import { along, armLines } from "./armLines";
import { ArmGhost } from "./ArmGhost";
import { ArmShape } from "./armShape";
import { Camera, type ViewName } from "./Camera";
import { type CarrierFrames, CellObjects } from "./CellObjects";
import { type Label, Labels } from "./Labels";
import { corners } from "./corners";
import { DropLines } from "./DropLines";
import { failedMoves, FailedTargets } from "./FailedTargets";
import { type Area, areaBetween, contains, WHOLE } from "./fitting";
import { FrameMarks } from "./FrameMarks";
import { hiddenLayers } from "./layers";
import { Lines } from "./lines";
import { MotionMarks } from "./MotionMarks";
import { NearPairs } from "./NearPairs";
import { DARK, LIGHT, type Look } from "./palette";
import { surfaceAt } from "./picking";
import { PointMarks } from "./PointMarks";
import { ReachSurface } from "./reach";
import { isSoftware } from "./software";
import { stage } from "./stage";
import { Trail } from "./trail";

/** Kinds of names that the border of the picture shows if their position is outside. */
const FAR_KINDS: ReadonlySet<Label["kind"]> = new Set(["failed", "selected"]);

/** Distance up to which *Fit* shows the targets of failed moves, and points and frames, as multiples of the arm's length. */
const FAR_FAILED = 10;
const FAR_NAMED = 3;

/** Time for which an update adds samples to the path, in ms. Further samples follow after the browser has handled input. */
const FOLLOWING = 30;

export class Viewport {
  readonly camera: Camera;
  readonly trail = new Trail();
  /** Centre point of the tool with which the operator jogs and teaches, in world. */
  tcp: Frame = IDENTITY;
  frames = 0;
  isFollowing = false;
  measured: readonly (readonly number[])[] = [];
  /** Links whose files cannot be drawn. */
  readonly faults = signal<readonly string[]>([]);
  private readonly renderer: WebGLRenderer;
  private readonly scene = new Scene();
  private readonly labels: Labels;
  private readonly marks = new FrameMarks();
  private readonly ruler = new Lines({ width: 2, isOnTop: true });
  private readonly points = new PointMarks();
  private readonly motion = new MotionMarks();
  private readonly drops = new DropLines();
  private readonly nearPairs = new NearPairs();
  private readonly failed = new FailedTargets();
  private readonly ghost = new ArmGhost();
  private room = new Group();
  private arm: ArmShape | undefined;
  private objects: CellObjects | undefined;
  private readonly reach = new ReachSurface(this.scene);
  private hasReach = false;
  private cell: Cell | undefined;
  private look: Look = LIGHT;
  private names: Label[] = [];
  /** Positions along the links of the arm. */
  private obstacles: readonly (readonly number[])[] = [];
  private isWaiting = false;
  /** Whether the path has not all samples yet, and another update follows. */
  private isBehind = false;
  /** Whether the picture shows everything, because the user has not changed its view. */
  private isFirst = false;
  /** Growth count of the path when everything was last shown. */
  private fitted = -1;
  /** Area of the picture in which everything was last shown. */
  private area: Area = WHOLE;
  private length = 1000;
  private floor = 0;

  constructor(private readonly canvas: HTMLCanvasElement, overlay: HTMLElement, private readonly store: Store) {
    // Without a graphics card, smooth edges and shadows used 230 of 290 ms for a frame.
    const isPlain = isSoftware();
    this.renderer = new WebGLRenderer({ canvas, antialias: !isPlain, alpha: true });
    this.renderer.shadowMap.enabled = !isPlain;
    this.renderer.shadowMap.type = PCFShadowMap;
    this.renderer.localClippingEnabled = true;
    this.camera = new Camera(canvas, () => this.request(), () => this.rememberView());
    this.labels = new Labels(overlay);
    this.scene.add(...this.trail.objects, ...this.motion.objects, this.marks.object, this.ruler.object, this.points.object, this.drops.object, this.nearPairs.object, this.failed.object, ...this.ghost.objects);
  }

  get drawCalls(): number {
    return this.renderer.info.render.calls;
  }

  resize(width: number, height: number): void {
    this.renderer.setPixelRatio(Math.min(devicePixelRatio, 2));
    this.renderer.setSize(width, height, false);
    this.camera.resize(width / Math.max(height, 1));
    this.fitAgain();
    this.request();
  }

  /** Builds the static parts. */
  build(cell: Cell, isDark: boolean): void {
    this.look = isDark ? DARK : LIGHT;
    this.faults.value = [];
    this.length = armLength(cell.arm);
    this.arm?.dispose();
    this.room.removeFromParent();
    const base = frameOf(cell.base);
    this.objects?.dispose();
    this.objects = new CellObjects(cell.objects ?? [], cell.parts ?? [], this.look);
    this.objects.place({ base, arm: armFrames(cell.arm, base, []), frames: cell.frames, tools: cell.tools }, [], new Map());
    this.floor = Math.min(floorHeight(cell.arm) + base.position[2], this.objects.lowest());
    this.room = stage(this.look, this.length, this.floor, isDark, this.renderer.shadowMap.enabled);
    this.arm = new ArmShape(cell.arm, cell.base, this.look, (fault) => {
      if (fault !== undefined) {
        this.faults.value = [...this.faults.peek(), fault];
      }
      this.fitAgain();
      this.request();
    });
    this.scene.add(this.room, this.arm.group, this.objects.group);
    if (this.cell !== cell) {
      this.trail.clear();
      this.cell = cell;
      this.update();
      this.showFirst(cell);
    }
    this.update();
  }

  /** Places all objects that depend on the shown time or the selection. */
  update(): void {
    const { cell, store } = this;
    if (cell === undefined) {
      return;
    }
    const base = frameOf(cell.base);
    const hasAll = this.trail.follow(store.samples, cell.arm, base, cell.phases, (index) => store.tools.get(index)?.pose ?? [], FOLLOWING);
    if (!hasAll && !this.isBehind) {
      this.isBehind = true;
      setTimeout(() => {
        this.isBehind = false;
        this.update();
      });
    }
    this.trail.showUpTo(store.time.value);
    const sample = store.panels.cell.sample.value;
    const placed = armFrames(cell.arm, base, sample?.joints ?? []);
    const before = this.tcp.position;
    const tool = handTool(store.panels.cell).pose;
    this.tcp = composed(placed.flange, frameOf(tool));
    if (this.hasReach) {
      this.reach.place(cell.arm, base, tool);
    }
    this.arm?.place(placed);
    this.placeObjects({ base, arm: placed, frames: store.panels.cell.frames.value, tools: store.panels.cell.tools.value });
    this.obstacles = armLines(cell.arm, base, placed).flatMap(along);
    if (this.isFollowing) {
      this.camera.move(new Vector3(...this.tcp.position).sub(new Vector3(...before)));
    }
    const { points, frames, motion, selectedPoint, unreachable } = store.panels.cell;
    this.points.place(points.value, selectedPoint.value, unreachable.value.reasons, this.length * 0.011, this.look);
    this.motion.place(motion.value);
    const { faults, refused } = store.panels.cell.history;
    const failed = [...failedMoves(motion.value.queue, faults, store.time.value), ...refused.at(store.time.value)];
    this.failed.place(failed, this.length * 0.02, this.look);
    this.ghost.place(cell, store.panels.cell.armGoal.value, tool, this.length * 0.11, this.look);
    const hasFrames = !hiddenLayers.peek().has("frames");
    this.marks.place({ cell: store.panels.cell, selection: store.selection.value, flange: placed.flange, base, hasFrames }, this.length, this.look);
    this.names = [...this.failed.labels, ...this.ghost.labels, ...this.nearPairs.labels, ...this.points.labels, ...this.marks.labels];
    this.drops.place([this.tcp.position, ...points.value.map(({ pose }) => pose), ...frames.value.map(({ pose }) => pose)], this.floor, this.length * 0.012, this.look);
    this.placeRuler();
    this.showLayers();
    this.names = this.names.map((label) => (FAR_KINDS.has(label.kind) ? { ...label, away: distance(this.tcp.position, label.at) } : label));
    if (this.trail.growth !== this.fitted) {
      this.fitted = this.trail.growth;
      this.fitAgain();
    }
    this.request();
  }

  /** Places the things around the arm, and marks the things that are too near to others at the shown time. */
  private placeObjects(frames: CarrierFrames): void {
    const [{ list }, t] = [this.store.panels.cell.history.encounters, this.store.time.value];
    const nearness = nearnessAt(list, t);
    this.objects?.place(frames, this.store.panels.cell.parts.value, nearness);
    this.arm?.mark(nearness);
    this.nearPairs.place(list, t);
  }

  private showLayers(): void {
    const hidden = hiddenLayers.peek();
    this.points.object.visible = !hidden.has("points");
    if (this.objects !== undefined) {
      this.objects.group.visible = !hidden.has("objects");
    }
    this.drops.object.visible &&= !hidden.has("heights");
    this.trail.objects.forEach((object) => (object.visible &&= !hidden.has("path")));
    this.motion.show(!hidden.has("ahead"));
    const isShown = ({ kind }: Label): boolean => !(kind === "point" && hidden.has("points")) && !(kind === "frame" && hidden.has("frames"));
    this.names = hidden.has("names") ? this.names.filter(({ kind }) => kind !== "point" && kind !== "frame" && kind !== "tool") : this.names.filter(isShown);
  }

  /** Shows the view of the last visit, otherwise everything. */
  private showFirst(cell: Cell): void {
    const view = storedView(remembered(viewKey(cell)));
    if (view === undefined) {
      this.fit("Iso");
      this.isFirst = true;
    } else {
      this.camera.restore(view);
    }
  }

  /** Shows everything again, until the user has changed the view. */
  private fitAgain(): void {
    if (this.isFirst) {
      this.fit();
      this.isFirst = true;
    }
  }

  private rememberView(): void {
    this.isFirst = false;
    if (this.cell !== undefined) {
      remember(viewKey(this.cell), JSON.stringify(this.camera.view));
    }
  }

  /** Shows the arm, its path, targets of failed moves, and the points and frames near it, between the bars over the picture. */
  fit(view?: ViewName): void {
    const { cell } = this;
    const base = new Vector3(...frameOf(cell?.base ?? []).position);
    const positions: (readonly [number, number, number])[] = [[base.x, base.y, this.floor]];
    const add = (at: readonly number[], far = FAR_NAMED): void => {
      const [x = 0, y = 0, z = 0] = at;
      if (new Vector3(x, y, z).distanceTo(base) < this.length * far) {
        positions.push([x, y, z]);
      }
    };
    corners([this.arm?.group, this.objects?.group]).forEach((at) => add(at));
    positions.push(...this.trail.positions());
    add(this.tcp.position);
    this.store.panels.cell.points.value.forEach(({ pose }) => add(pose));
    this.store.panels.cell.frames.value.forEach(({ pose }) => add(pose));
    this.failed.labels.forEach(({ at }) => add(at, FAR_FAILED));
    this.area = this.free();
    this.camera.show(positions, this.area, view);
    this.isFirst = false;
  }

  /** Returns the position on the arm, a thing or the floor at a location of the canvas. */
  surfaceAt(x: number, y: number): readonly number[] | undefined {
    return surfaceAt(this.floor, x, y, [this.canvas.clientWidth, this.canvas.clientHeight], this.camera.lens, [this.arm?.group, this.objects?.group]);
  }

  /** Returns the location of a position in the picture, in px from its upper left corner. */
  locationOf([x = 0, y = 0, z = 0]: readonly number[]): [number, number] {
    const place = new Vector3(x, y, z).project(this.camera.lens);
    return [(place.x + 1) * 0.5 * this.canvas.clientWidth, (1 - place.y) * 0.5 * this.canvas.clientHeight];
  }

  /** Returns the corners around the parts of the arm, in world. */
  outline(): number[][] {
    return corners([this.arm?.group]);
  }

  /** Shows everything from the direction of a view, or from the present direction, also after a reload. */
  choose(view?: ViewName): void {
    this.fit(view);
    this.rememberView();
  }

  /** Turns the picture by degrees, or zooms by a factor. */
  turn(sideways: number, up: number, factor = 1): void {
    this.camera.turn(sideways, up, factor);
    this.rememberView();
  }

  showReach(isShown: boolean): void {
    this.hasReach = isShown;
    this.reach.remove();
    this.update();
  }

  request(): void {
    if (!this.isWaiting) {
      this.isWaiting = true;
      requestAnimationFrame(() => {
        this.isWaiting = false;
        this.draw();
      });
    }
  }

  dispose(): void {
    this.camera.dispose();
    this.renderer.dispose();
  }

  private draw(): void {
    this.renderer.render(this.scene, this.camera.lens);
    this.frames += 1;
    this.labels.draw(this.names, this.obstacles, this.camera.lens, this.canvas, unitOf(this.cell));
    if (this.isFirst && !contains(this.free(), this.area)) {
      this.fitAgain();
    }
  }

  /** Returns the area between the bars over the picture. */
  private free(): Area {
    return areaBetween(this.canvas.clientHeight, this.labels.bars(this.canvas));
  }

  private placeRuler(): void {
    const [from, to] = this.measured;
    this.ruler.segments.clear();
    if (from !== undefined && to !== undefined) {
      const { r, g, b } = new Color(this.look.selected);
      this.ruler.segments.add(from, to, [r, g, b]);
      this.names.push({ text: lengthText(distance(from, to), 2, unitOf(this.cell)), at: [0, 1, 2].map((axis) => ((from[axis] ?? 0) + (to[axis] ?? 0)) / 2), kind: "measure" });
    }
    this.ruler.show();
  }
}

function distance(from: readonly number[], to: readonly number[]): number {
  return Math.hypot(...[0, 1, 2].map((axis) => (to[axis] ?? 0) - (from[axis] ?? 0)));
}
