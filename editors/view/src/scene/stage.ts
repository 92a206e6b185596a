// Surroundings of the arm: light, floor and grid.

import { DirectionalLight, GridHelper, Group, HemisphereLight, Mesh, PlaneGeometry, ShadowMaterial } from "three";
import type { Look } from "./palette";

/** `length` is the length of the arm, `height` the height of the floor. Without shadows, the floor is its grid. */
export function stage(look: Look, length: number, height: number, isDark: boolean, hasShadows: boolean): Group {
  const group = new Group();
  const sun = new DirectionalLight(0xffffff, isDark ? 2 : 2.4);
  sun.position.set(length * 1.2, -length * 1.6, length * 3);
  sun.castShadow = true;
  sun.shadow.mapSize.set(2048, 2048);
  sun.shadow.radius = 5;
  sun.shadow.normalBias = 2;
  Object.assign(sun.shadow.camera, { left: -length * 2, right: length * 2, top: length * 2, bottom: -length * 2, near: length * 0.1, far: length * 8 });
  const side = new DirectionalLight(0xbcd4ff, 0.7);
  side.position.set(-length, length, length);
  const floor = new Mesh(new PlaneGeometry(length * 8, length * 8), new ShadowMaterial({ opacity: isDark ? 0.45 : 0.16, depthWrite: false }));
  floor.position.z = height - 1;
  floor.receiveShadow = true;
  // It draws nothing but shadows, and would take much time to do so in software.
  floor.visible = hasShadows;
  const size = Math.ceil((length * 2.6) / 500) * 1000;
  const fine = new GridHelper(size, size / 100, look.gridFine, look.gridFine).rotateX(Math.PI / 2);
  const coarse = new GridHelper(size, size / 500, look.gridCoarse, look.gridCoarse).rotateX(Math.PI / 2);
  fine.position.z = height;
  coarse.position.z = height + 0.3;
  group.add(new HemisphereLight(look.sky, look.ground, isDark ? 1.1 : 1.5), sun, side, floor, fine, coarse);
  group.children.filter((child) => child instanceof HemisphereLight).forEach((light) => light.position.set(0, 0, 1));
  return group;
}
