// SPDX-License-Identifier: GPL-3.0-or-later
// The airplane in three dimensions, from behind its track; what the autopilot takes to be its
// attitude is the outline beside the truth.
import { AmbientLight, Color, DirectionalLight, EdgesGeometry, Group, GridHelper, LineBasicMaterial, LineSegments, Mesh,
  MeshLambertMaterial, PerspectiveCamera, Scene, WebGLRenderer } from 'three';
import { byId, colour, onThemeChange } from '../dom';
import type { Kind } from '../document';
import type { Flight, Series } from '../flight';
import type { View } from '../view';
import { isFlyingWing } from './airplane';
import { kTailed, kWing } from './shapes';
import type { Part } from './shapes';

interface Angles { roll?: Series; pitch?: Series; yaw?: Series }

function outline(parts: Part[]): Group {
  const group = new Group();
  for (const { geometry, at } of parts) {
    const lines = new LineSegments(new EdgesGeometry(geometry, 30), new LineBasicMaterial());
    lines.position.set(...at);
    group.add(lines);
  }
  return group;
}

function solid(parts: Part[]): Group {
  const group = new Group();
  for (const { geometry, at } of parts) {
    const mesh = new Mesh(geometry, new MeshLambertMaterial());
    mesh.position.set(...at);
    group.add(mesh);
  }
  return group;
}

export class Attitude {
  private readonly canvas = byId<HTMLCanvasElement>('attitude');
  private readonly renderer: WebGLRenderer;
  private readonly scene = new Scene();
  private readonly camera = new PerspectiveCamera(35, 1, 0.1, 60);
  private readonly parts: Part[];
  private readonly airplane: Group;
  private readonly estimated: Group;
  private readonly grid = new GridHelper(24, 24);
  private readonly truth: Angles;
  private readonly estimate?: Angles;

  // Throws where there is no WebGL.
  constructor(private readonly flight: Flight, private readonly view: View) {
    this.parts = isFlyingWing(flight.document) ? kWing : kTailed;
    this.airplane = solid(this.parts);
    this.estimated = outline(this.parts);
    this.canvas.dataset.shape = this.parts === kWing ? 'flying wing' : 'with a tail';
    this.renderer = new WebGLRenderer({ canvas: this.canvas, antialias: true, powerPreference: 'low-power' });
    this.truth = this.angles('truth', 'estimate');
    const estimate = this.angles('estimate');
    if (this.truth.roll && this.truth.roll.kind === 'truth' && estimate.roll?.kind === 'estimate') this.estimate = estimate;
    const sun = new DirectionalLight(0xffffff, 2.2);
    sun.position.set(2, 5, 3);
    this.scene.add(new AmbientLight(0xffffff, 1.3), sun, this.airplane, this.grid);
    if (this.estimate) this.scene.add(this.estimated);
    for (const each of [this.airplane, this.estimated]) each.rotation.order = 'YXZ';
    this.grid.position.y = -1.5;
    this.paint();
    this.resize();
    view.moved.on(() => this.draw());
    onThemeChange(() => { this.paint(); this.draw(); });
    new ResizeObserver(() => this.resize()).observe(this.canvas);
  }
  private angles(...kinds: Kind[]): Angles {
    const find = (name: string): Series | undefined => this.flight.find(name, ...kinds);
    return { roll: find('roll_deg'), pitch: find('pitch_deg'), yaw: find('yaw_deg') };
  }
  private paint(): void {
    this.scene.background = new Color(colour('scene'));
    const grid = this.grid.material;
    grid.vertexColors = false;
    grid.color = new Color(colour('faint'));
    grid.transparent = true;
    grid.opacity = 0.45;
    grid.needsUpdate = true;
    this.airplane.children.forEach((part, i) => { ((part as Mesh).material as MeshLambertMaterial).color.set(colour(this.parts[i].ink)); });
    for (const part of this.estimated.children) ((part as LineSegments).material as LineBasicMaterial).color.set(colour('c2'));
  }
  private resize(): void {
    const { clientWidth: width, clientHeight: height } = this.canvas;
    if (width === 0 || height === 0) return;
    this.renderer.setPixelRatio(Math.min(devicePixelRatio || 1, 2));
    this.renderer.setSize(width, height, false);
    this.camera.aspect = width / height;
    this.camera.updateProjectionMatrix();
    this.draw();
  }
  private turn(group: Group, { roll, pitch, yaw }: Angles, heading: number): void {
    const { time_s } = this.view;
    const radians = (series: Series | undefined): number => (this.flight.smooth(series, time_s, true) || 0) * Math.PI / 180;
    group.rotation.set(radians(pitch), heading - radians(yaw), -radians(roll));
  }
  draw(): void {
    if (this.canvas.clientWidth === 0) return;
    const heading = (this.flight.smooth(this.truth.yaw, this.view.time_s, true) || 0) * Math.PI / 180;
    this.turn(this.airplane, this.truth, heading);
    if (this.estimate) this.turn(this.estimated, this.estimate, heading);
    this.grid.rotation.y = heading;
    this.camera.position.set(0, 1.15, 3.5);
    this.camera.lookAt(0, 0, -0.2);
    this.renderer.render(this.scene, this.camera);
  }
}
