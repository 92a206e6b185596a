// Camera: orbit, pan and zoom, views along the axes, and following the tool centre point.

import { OrthographicCamera, PerspectiveCamera, Vector3 } from "three";
import { OrbitControls } from "three/addons/controls/OrbitControls.js";
import { type Area, fitted } from "./fitting";

export const VIEWS = { Iso: [1, -1.25, 0.75], Front: [1, 0, 0], Right: [0, 1, 0], Top: [0, -0.0001, 1] } as const;
export type ViewName = keyof typeof VIEWS;
export type Lens = PerspectiveCamera | OrthographicCamera;

/** Vertical angle of view, in degrees. */
const ANGLE = 35;
const SLOPE = Math.tan((ANGLE * Math.PI) / 360);

/** Farthest visible distance, in mm. */
const FAR = 100_000;

export class Camera {
  private readonly perspective = new PerspectiveCamera(ANGLE, 1, 10, FAR);
  /** Lens of the views along an axis, in which lengths can be compared. */
  private readonly parallel = new OrthographicCamera(-1, 1, 1, -1, -FAR, FAR);
  private readonly controls: OrbitControls;
  private aspect = 1;
  /** Height above the centre of a parallel picture without zoom, in mm. */
  private half = 1000;

  /** `onEnd` is called when the user has turned, moved or zoomed the picture. */
  constructor(element: HTMLElement, onChange: () => void, onEnd: () => void) {
    this.perspective.up.set(0, 0, 1);
    this.parallel.up.set(0, 0, 1);
    this.controls = new OrbitControls(this.perspective, element);
    this.controls.zoomToCursor = true;
    this.controls.addEventListener("change", onChange);
    this.controls.addEventListener("end", onEnd);
  }

  get lens(): Lens {
    return this.controls.object === this.parallel ? this.parallel : this.perspective;
  }

  /** Sets the aspect ratio of the picture, its width divided by its height. */
  resize(aspect: number): void {
    this.aspect = aspect;
    this.perspective.aspect = aspect;
    this.perspective.updateProjectionMatrix();
    this.shape();
  }

  /** Shows positions within an area of the picture, from the direction of a view, or from the present direction. */
  show(positions: readonly (readonly [number, number, number])[], area: Area, view?: ViewName): void {
    const back = (view === undefined ? this.lens.position.clone().sub(this.controls.target) : new Vector3(...VIEWS[view])).normalize();
    const across = new Vector3(0, 0, 1).cross(back).normalize();
    const up = back.clone().cross(across);
    const isParallel = view === undefined ? this.lens === this.parallel : view !== "Iso";
    const axes = { across: across.toArray(), up: up.toArray(), back: back.toArray() };
    const { target, distance } = fitted(positions, axes, { slope: SLOPE, aspect: this.aspect, isParallel }, area);
    const at = new Vector3(...target).addScaledVector(back, distance);
    this.restore([...at.toArray(), ...target, isParallel ? distance * SLOPE : 0]);
  }

  /** Returns the position and the target in mm, and the half height of a parallel picture, otherwise 0. */
  get view(): readonly number[] {
    const height = this.lens === this.parallel ? this.half / this.parallel.zoom : 0;
    return [...this.lens.position.toArray(), ...this.controls.target.toArray(), height];
  }

  /** Sets the position, the target, and the half height of a parallel picture. */
  restore(view: readonly number[]): void {
    const half = view[6] ?? 0;
    this.controls.object = half > 0 ? this.parallel : this.perspective;
    if (half > 0) {
      this.half = half;
      this.parallel.zoom = 1;
      this.shape();
    }
    this.lens.position.fromArray(view);
    this.controls.target.fromArray(view, 3);
    this.controls.update();
  }

  move(way: Vector3): void {
    this.controls.target.add(way);
    this.lens.position.add(way);
    this.controls.update();
  }

  /** Rotates by degrees around the target, or moves closer by a factor. */
  turn(sideways: number, up: number, factor = 1): void {
    const isParallel = this.lens === this.parallel;
    const arm = this.lens.position.clone().sub(this.controls.target).multiplyScalar(isParallel ? 1 : factor);
    if (isParallel) {
      this.parallel.zoom /= factor;
      this.shape();
    }
    arm.applyAxisAngle(new Vector3(0, 0, 1), (sideways * Math.PI) / 180);
    const across = new Vector3(-arm.y, arm.x, 0).normalize();
    const raised = arm.clone().applyAxisAngle(across, (-up * Math.PI) / 180);
    const isSteep = Math.hypot(raised.x, raised.y) < 0.05 * raised.length();
    this.lens.position.copy(this.controls.target).add(isSteep ? arm : raised);
    this.controls.update();
  }

  dispose(): void {
    this.controls.dispose();
  }

  /** Sets the height and width of the parallel picture. */
  private shape(): void {
    const { half, aspect } = this;
    Object.assign(this.parallel, { left: -half * aspect, right: half * aspect, bottom: -half, top: half });
    this.parallel.updateProjectionMatrix();
  }
}
