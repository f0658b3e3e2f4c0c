// SPDX-License-Identifier: GPL-3.0-or-later
// The airplanes that the attitude view draws, some 3 units of span. Nose along -z, right wing along +x.
import { BoxGeometry, BufferGeometry, CylinderGeometry, Float32BufferAttribute } from 'three';

export interface Part { geometry: BufferGeometry; at: [number, number, number]; ink: string }

function box(size: [number, number, number], at: [number, number, number], ink: string): Part {
  return { geometry: new BoxGeometry(...size), at, ink };
}

// A plate from root to tip: `root` and `tip` are where its front and its back are, along z.
function panel(root_x: number, root: [number, number], tip_x: number, tip: [number, number], tip_y: number, thick: number): BufferGeometry {
  const corners = [[root_x, 0, root[0]], [root_x, 0, root[1]], [tip_x, tip_y, tip[1]], [tip_x, tip_y, tip[0]]];
  const points = [...corners.map(([x, y, z]) => [x, y + thick / 2, z]), ...corners.map(([x, y, z]) => [x, y - thick / 2, z])].flat();
  const sides = [0, 1, 2, 3].flatMap((i) => { const next = (i + 1) % 4; return [i, i + 4, next, next, i + 4, next + 4]; });
  const faces = [0, 1, 2, 0, 2, 3, 4, 6, 5, 4, 7, 6, ...sides];
  const turned = tip_x < root_x ? faces.map((_, i) => faces[i - i % 3 + 2 - i % 3]) : faces;
  const geometry = new BufferGeometry();
  geometry.setAttribute('position', new Float32BufferAttribute(points, 3));
  geometry.setIndex(turned);
  const flat = geometry.toNonIndexed();
  flat.computeVertexNormals();
  return flat;
}

export const kTailed: Part[] = [
  { geometry: new CylinderGeometry(0.13, 0.07, 2, 10).rotateX(Math.PI / 2), at: [0, 0, 0], ink: 'c7' },
  box([2.8, 0.05, 0.42], [0, 0.14, -0.3], 'c0'),
  box([0.95, 0.04, 0.26], [0, 0.04, 0.88], 'c1'),
  box([0.04, 0.42, 0.28], [0, 0.22, 0.88], 'c1'),
];

const wings = (side: 1 | -1): Part[] => [
  { geometry: panel(0, [-0.75, 0.3], side * 1.45, [0.3, 0.72], 0.06, 0.06), at: [0, 0, 0], ink: 'c0' },
  { geometry: panel(side * 0.25, [0.35, 0.5], side * 1.35, [0.7, 0.85], 0.06, 0.03), at: [0, 0, 0], ink: 'c1' },  // elevon
  box([0.04, 0.3, 0.46], [side * 1.47, 0.16, 0.52], 'c1'),
];

export const kWing: Part[] = [
  { geometry: new CylinderGeometry(0.12, 0.08, 0.95, 10).rotateX(Math.PI / 2), at: [0, 0.03, -0.2], ink: 'c7' },
  ...wings(1), ...wings(-1),
];
