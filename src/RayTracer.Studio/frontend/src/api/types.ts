/** What the server sends and takes: the wire format of RayTracer.Studio's endpoints. */

export type Json = null | boolean | number | string | Json[] | { [key: string]: Json };
export type Vec3 = [number, number, number];
/** x, y, width, height in pixels of the picture. */
export type Region = [number, number, number, number];

export interface Diagnostic {
  line: number;
  column: number;
  from: number;
  to: number;
  severity: "error" | "warning";
  message: string;
}

export interface DocumentState {
  revision: number;
  name: string;
  path: string | null;
  isDirty: boolean;
  canUndo: boolean;
  canRedo: boolean;
  undoLabel: string | null;
  redoLabel: string | null;
  diagnostics: Diagnostic[];
  isGood: boolean;
}

export type Quality = "draft" | "good" | "final";
export type RenderStatus = "rendering" | "paused" | "stopped" | "done" | "idle";

export interface RenderState {
  status: RenderStatus;
  width: number;
  height: number;
  samples: number;
  samplesTotal: number;
  raysPerSecond: number;
  seconds: number;
  secondsLeft: number | null;
  /** Relative standard error of the mean, averaged over the pixels. */
  noise: number | null;
  threads: number;
  cores: number;
  map: string;
  region: Region | null;
  quality: Quality | null;
  isPreview: boolean;
  badSamples: number;
}

export interface Snapshot {
  id: number;
  label: string;
}

export interface Recovery {
  id: string;
  name: string;
  time: string;
}

export interface StudioState {
  version: number;
  document: DocumentState;
  selection: string | null;
  render: RenderState;
  tone: { exposure: number; toneMap: string; choices: string[] };
  snapshots: Snapshot[];
  recovery: Recovery[];
  message: { id: number; kind: "info" | "error"; text: string } | null;
  jobs: { id: number; text: string; fraction: number | null }[];
}

export interface OutlineNode {
  pointer: string;
  name: string;
  type: string;
  summary: string;
  isLight: boolean;
  color: string | null;
  children: OutlineNode[];
}

export interface Outline {
  camera: OutlineNode | null;
  render: OutlineNode | null;
  background: OutlineNode | null;
  environment: OutlineNode | null;
  ambient: OutlineNode | null;
  shapes: OutlineNode[];
  lights: OutlineNode[];
  materials: OutlineNode[];
  textures: OutlineNode[];
  objects: OutlineNode[];
}

export interface Parameter {
  key: string;
  /** A ParameterKind of the scene format, in camel case. */
  kind: string;
  summary: string;
  unit: string;
  minimum: number | null;
  maximum: number | null;
  minimumIsExclusive: boolean;
  required: boolean;
  choices: string[];
  default: Json;
  range: string;
  /** shape, material or texture, where it is one or several. */
  family: string | null;
  /** The section that it is, or that its elements are. */
  record: string | null;
  /** Whether it is a texture in whose place a number may stand. */
  isNumber: boolean;
}

export interface RecordType {
  name: string;
  summary: string;
  parameters: Parameter[];
  /** The families among which it is offered to be added. */
  addedAs: string[];
}

export interface SchemaAnswer {
  schema: Json;
  types: Record<string, RecordType[]>;
  sections: Record<string, RecordType>;
  refractiveIndices: { name: string; value: number }[];
  colors: Record<string, string>;
  maps: ViewMap[];
}

/** One of the things that the view can show of the picture: its light, or an auxiliary image. */
export interface ViewMap {
  name: string;
  isLight: boolean;
  title: string;
  why: string;
  /** The colours of its legend from left to right: red, green and blue from 0 to 1. */
  scale: Vec3[];
}

export interface ValueAnswer {
  pointer: string;
  type: string | null;
  family: string | null;
  value: Json;
  effective: Record<string, Json> | null;
  from: number;
  to: number;
}

export interface ViewCamera {
  position: Vec3;
  right: Vec3;
  up: Vec3;
  forward: Vec3;
  /** Full vertical angle in degrees. */
  fieldOfView: number;
  width: number;
  height: number;
}

export type GizmoKind = "move" | "rotate" | "scale";

export interface GizmoAnswer {
  kind: GizmoKind;
  middle: Vec3;
  center: [number, number] | null;
  handles: { axis: number; points: [number, number][] }[];
}

export interface HandleDrag {
  pointer: string;
  kind: GizmoKind;
  axis: number | null;
  from: [number, number];
  to: [number, number];
  gesture: string;
}

export interface PickAnswer {
  pointer: string | null;
  distance: number | null;
  position: Vec3 | null;
  material: string | null;
}

export interface MaskAnswer {
  width: number;
  height: number;
  /** Pairs of start and length, in pixels counted row by row from the top. */
  runs: number[];
}

export interface PathVertex {
  event: "camera" | "diffuse" | "specular" | "emission" | "miss" | "absorbed" | "end";
  position: Vec3;
  normal: Vec3 | null;
  pointer: string | null;
  name: string | null;
  material: string | null;
  weight: Vec3;
  throughput: Vec3;
  /** Per steradian; null where the direction had no choice. */
  pdf: number | null;
  contribution: Vec3;
  parts: { emitted: Vec3; ambient: Vec3; direct: Vec3 } | null;
}

export interface PathSample {
  sample: number;
  radiance: Vec3;
  vertices: PathVertex[];
}

export interface PathsAnswer {
  x: number;
  y: number;
  /** The mean of all samples rendered so far; null where there are none. */
  pixel: Vec3 | null;
  samples: PathSample[];
}

export interface WireframeAnswer {
  shapes: { pointer: string | null; lines: Vec3[][] }[];
  camera: ViewCamera;
}

export interface ConvergenceAnswer {
  points: { samples: number; error: number }[];
  slope: number | null;
}

export interface FolderListing {
  path: string;
  parent: string | null;
  folders: string[];
  files: { name: string; size: number; time: string }[];
}

export interface ReportTime {
  scene: number;
  figure: string;
  width: number;
  samples: number;
  reportSeconds: number;
  seconds: number;
}

/** A format of files that pictures are written to. */
export interface PictureFormat {
  /** The ending of names, without its dot. */
  value: string;
  label: string;
  hasDepth: boolean;
  hasLayers: boolean;
  /** The film itself, which is only written to files. */
  isFilm: boolean;
}
