// Camera: orbit, pan and zoom, views along the axes, and following the tool centre point.

import { PerspectiveCamera, Sphere, Vector3 } from "three";
import { OrbitControls } from "three/addons/controls/OrbitControls.js";

export const VIEWS = { Iso: [1, -1.25, 0.75], Front: [1, 0, 0], Right: [0, 1, 0], Top: [0, -0.0001, 1] } as const;
export type ViewName = keyof typeof VIEWS;

export class Camera {
  readonly lens = new PerspectiveCamera(35, 1, 10, 100_000);
  private readonly controls: OrbitControls;

  /** `onEnd` is called when the user has turned, moved or zoomed the picture. */
  constructor(element: HTMLElement, onChange: () => void, onEnd: () => void) {
    this.lens.up.set(0, 0, 1);
    this.controls = new OrbitControls(this.lens, element);
    this.controls.zoomToCursor = true;
    this.controls.addEventListener("change", onChange);
    this.controls.addEventListener("end", onEnd);
  }

  /** Shows a sphere from the direction of a view, or from the present direction. */
  show(sphere: Sphere, view?: ViewName): void {
    const direction = view === undefined ? this.lens.position.clone().sub(this.controls.target) : new Vector3(...VIEWS[view]);
    const half = (this.lens.fov * Math.PI) / 360;
    const distance = sphere.radius / Math.sin(Math.min(half, Math.atan(Math.tan(half) * this.lens.aspect)));
    this.controls.target.copy(sphere.center);
    this.lens.position.copy(sphere.center).addScaledVector(direction.normalize(), distance);
    this.controls.update();
  }

  /** Returns the position and the target, in mm. */
  get view(): readonly number[] {
    return [...this.lens.position.toArray(), ...this.controls.target.toArray()];
  }

  /** Sets the position and the target. */
  restore(view: readonly number[]): void {
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
    const arm = this.lens.position.clone().sub(this.controls.target).multiplyScalar(factor);
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
}
