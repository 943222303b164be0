/** Draws the scene's wires and the light's paths on a canvas. */

import type { InspectedPath, InspectedWay, TreeWalk, Vec3, CameraFrame, WireframeView } from "../api/types";
import { toHex } from "../json/color";
import { project, projectLine, rayThrough } from "../math/projection";
import { add, scale } from "../math/vec3";

export interface Palette {
  wire: string;
  selected: string;
  camera: string;
  faint: string;
}

/** How a path's line is coloured: by the light it brought, brightened so that dark paths can be seen. */
function pathColor(radiance: Vec3): string {
  const largest = Math.max(...radiance);
  return largest > 0 ? toHex(scale(radiance, 1 / largest)) : "#808080";
}

/** What is open, and what is pointed at; -1 for none. */
export interface Marks {
  open: number;
  vertex: number;
  light: number;
  sample: number;
}

export const noMarks: Marks = { open: -1, vertex: -1, light: -1, sample: -1 };

const reach = 10;

/** What a place of the drawing is at: a vertex of the chosen path, a light that its open vertex asks, or another path. */
export function marksAt(camera: CameraFrame, samples: readonly InspectedPath[], chosen: number, open: number, farAway: number, at: { x: number; y: number }): Marks {
  const found = { ...noMarks, open };
  let least = reach;
  const near = (point: Vec3, marks: Partial<Marks>) => {
    const seen = project(camera, point);
    const distance = seen ? Math.hypot(seen.x - at.x, seen.y - at.y) : Infinity;
    if (distance >= least) return;
    least = distance;
    Object.assign(found, noMarks, { open }, marks);
  };
  const own = samples.find((s) => s.sample === chosen);
  if (own) pathPoints(own, farAway).forEach((p, vertex) => near(p, { vertex }));
  own?.vertices[open]?.lights.forEach((l, light) => l.point && near(l.point, { light }));
  for (const s of samples) if (s !== own) pathPoints(s, farAway).slice(2).forEach((p) => near(p, { sample: s.sample }));
  return found;
}

export class SceneDrawing {
  constructor(
    private readonly context: CanvasRenderingContext2D,
    private readonly camera: CameraFrame,
    private readonly palette: Palette,
  ) {}

  private polyline(points: Vec3[], color: string, width: number, alpha = 1): void {
    const { context } = this;
    context.strokeStyle = color;
    context.lineWidth = width;
    context.globalAlpha = alpha;
    context.beginPath();
    points.slice(1).forEach((b, i) => {
      const line = projectLine(this.camera, points[i]!, b);
      if (!line) return;
      context.moveTo(line[0].x, line[0].y);
      context.lineTo(line[1].x, line[1].y);
    });
    context.stroke();
    context.globalAlpha = 1;
  }

  wires(answer: WireframeView, selected: string | null): void {
    for (const { pointer, lines } of answer.shapes) {
      const isSelected = pointer !== null && pointer === selected;
      for (const line of lines) this.polyline(line, isSelected ? this.palette.selected : this.palette.wire, isSelected ? 1.5 : 1);
    }
  }

  /** The scene's camera as a small pyramid, a tenth of the way to what it looks at. */
  eye(view: CameraFrame, depth: number): void {
    const corners = [[0, 0], [view.width, 0], [view.width, view.height], [0, view.height]].map(([x, y]) => {
      const { origin, direction } = rayThrough(view, { x: x!, y: y! });
      return add(origin, scale(direction, depth));
    });
    this.polyline([...corners, corners[0]!], this.palette.camera, 1.5);
    for (const corner of corners) this.polyline([view.position, corner], this.palette.camera, 1);
  }

  path(sample: InspectedPath, isChosen: boolean, farAway: number, marks: Marks = noMarks): void {
    const points = pathPoints(sample, farAway);
    const color = pathColor(sample.radiance);
    const isPointed = sample.sample === marks.sample;
    if (isChosen) this.polyline(points, this.palette.faint, 5, 0.7);
    this.polyline(points, color, isChosen || isPointed ? 2 : 1, isChosen || isPointed ? 1 : 0.45);
    if (!isChosen) return;
    sample.vertices[marks.open]?.lights.forEach((light, i) => {
      if (light.point) this.polyline([points[marks.open]!, light.point], light.outcome === "arrives" ? this.palette.selected : this.palette.wire, i === marks.light ? 4 : 1.5);
    });
    const marked = marks.vertex >= 0 ? marks.vertex : marks.open;
    points.forEach((point, i) => this.dot(point, color, i, i === marked ? 7 : 3.5));
  }

  /** A part from a light, from where it is joined with the camera's. */
  way(way: InspectedWay): void {
    this.polyline(way.points, this.palette.selected, 2.5);
    way.points.slice(1).forEach((point, i) => this.dot(point, this.palette.selected, i + 1));
  }

  /** The nodes of a tree that a ray has visited before a step, the last one brightest, and the ray. */
  walk(walk: TreeWalk, step: number): void {
    const visited = walk.steps.slice(0, step);
    visited.forEach(({ lines }, i) => {
      const isLast = i === step - 1;
      for (const line of lines) this.polyline(line, isLast ? this.palette.selected : this.palette.camera, isLast ? 2 : 1, isLast ? 1 : 0.35);
    });
    this.polyline([walk.start, walk.end], this.palette.selected, 2);
  }

  private dot(point: Vec3, color: string, index: number, radius = 3.5): void {
    const at = project(this.camera, point);
    if (!at) return;
    const { context } = this;
    context.fillStyle = color;
    context.beginPath();
    context.arc(at.x, at.y, radius, 0, 2 * Math.PI);
    context.fill();
    context.fillStyle = this.palette.selected;
    context.fillText(String(index), at.x + 6, at.y - 5);
  }
}

/** The places of a path. One that leaves the scene ends without a place to end at: its last stretch is cut. */
export function pathPoints(sample: InspectedPath, farAway: number): Vec3[] {
  const points = sample.vertices.map((v) => v.position).filter((p) => p?.every(Number.isFinite));
  return points.map((p, i) => {
    const before = points[i - 1];
    if (!before) return p;
    const way: Vec3 = [p[0] - before[0], p[1] - before[1], p[2] - before[2]];
    const length = Math.hypot(...way);
    return length > farAway ? add(before, scale(way, farAway / length)) : p;
  });
}
