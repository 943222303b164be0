/** What the server sends and takes: written from its records by the tests, where RAYTRACER_UPDATE is 1. */

export type Json = null | boolean | number | string | Json[] | { [key: string]: Json };
export type Vec3 = [number, number, number];

export interface AnimatedValue {
  pointer: string;
  value: Json;
  hasKey: boolean;
}

export interface CameraFrame {
  position: Vec3;
  right: Vec3;
  up: Vec3;
  forward: Vec3;
  fieldOfView: number;
  width: number;
  height: number;
  lookAt: Vec3;
}

export interface CameraPose {
  position: Vec3;
  lookAt: Vec3;
  up: Vec3;
  fieldOfView: number;
  viewSize: number;
}

export interface CatalogueParameter {
  key: string;
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
  family: string | null;
  record: string | null;
  isNumber: boolean;
}

export interface CatalogueType {
  name: string;
  summary: string;
  parameters: CatalogueParameter[];
  addedAs: string[];
}

export type ComparisonMap = "difference" | "flip";

export interface ContributionParts {
  emitted: number[];
  ambient: number[];
  direct: number[];
}

export interface Convergence {
  points: ConvergencePoint[];
  slope: number | null;
}

export interface ConvergencePoint {
  samples: number;
  error: number;
}

export interface DocumentStatus {
  revision: number;
  name: string;
  path: string | null;
  isDirty: boolean;
  canUndo: boolean;
  canRedo: boolean;
  undoLabel: string | null;
  redoLabel: string | null;
  diagnostics: PlacedDiagnostic[];
  isGood: boolean;
  builtRevision: number;
  document: number;
  hasPicture: boolean;
  reading: string | null;
}

export type ExposureRule = "stops" | "limited" | "auto";

export interface FolderListing {
  path: string;
  parent: string | null;
  folders: string[];
  files: ListedFile[];
}

export interface GizmoHandle {
  axis: number;
  points: [number, number][];
}

export interface GizmoHandles {
  kind: GizmoKind;
  middle: Vec3;
  center: [number, number] | null;
  handles: GizmoHandle[];
}

export type GizmoKind = "move" | "rotate" | "scale";

export interface HandleDrag {
  pointer: string;
  kind: GizmoKind;
  axis: number | null;
  from: [number, number];
  to: [number, number];
  gesture: string;
}

export interface HelpEntry {
  id: string;
  title: string;
  group: string;
  summary: string;
}

export interface HelpFinding {
  page: string;
  title: string;
  section: string;
  anchor: string;
  excerpt: string;
}

export interface HelpFindings {
  findings: HelpFinding[];
}

export interface HelpIndex {
  pages: HelpEntry[];
}

export interface HelpPage {
  id: string;
  title: string;
  html: string;
}

export interface InspectedEmission {
  name: string;
  radiance: Vec3;
  scatterPdf: number | null;
  lightPdf: number | null;
  weight: number;
  isFoundOtherwise: boolean;
}

export interface InspectedFactor {
  kind: WayFactor;
  value: Vec3;
  divides: boolean;
}

export interface InspectedLight {
  name: string;
  pointer: string | null;
  outcome: string;
  blocker: string | null;
  blockerPointer: string | null;
  radiance: Vec3;
  pdf: number;
  scatterPdf: number | null;
  bsdf: Vec3;
  cosine: number;
  weight: number;
  transmittance: Vec3;
  contribution: Vec3;
  point: Vec3 | null;
}

export interface InspectedPath {
  sample: number;
  radiance: Vec3;
  vertices: InspectedVertex[];
  ways: InspectedWay[];
  sentence: string;
}

export interface InspectedPixel {
  x: number;
  y: number;
  pixel: Vec3 | null;
  rendered: number;
  total: number;
  samples: InspectedPath[];
}

export interface InspectedVertex {
  event: string;
  position: Vec3;
  normal: Vec3 | null;
  pointer: string | null;
  name: string;
  material: string;
  weight: Vec3;
  throughput: Vec3;
  pdf: number | null;
  contribution: number[];
  parts: ContributionParts;
  bsdf: Vec3 | null;
  cosine: number;
  survival: number;
  end: string;
  passed: Vec3;
  dispersion: Vec3;
  emission: InspectedEmission | null;
  lights: InspectedLight[];
}

export interface InspectedWay {
  lightVertices: number;
  cameraVertices: number;
  event: string;
  radiance: Vec3;
  weight: number;
  things: string[];
  points: Vec3[];
  light: string;
  factors: InspectedFactor[];
}

export interface Job {
  id: number;
  text: string;
  fraction: number;
}

export interface KeyChoice {
  keys: string;
  numbers: number[];
}

export interface LightBody {
  pointer: string;
  kind: string;
  place: [number, number];
  lines: [number, number][][];
  handles: LightHandle[];
}

export interface LightDrag {
  pointer: string;
  kind: LightHandleKind;
  to: [number, number];
  gesture: string;
}

export interface LightHandle {
  kind: LightHandleKind;
  at: [number, number];
}

export type LightHandleKind = "direction" | "cone" | "beam" | "radius";

export interface LightShare {
  name: string;
  share: number;
  variance: number;
  samples: number[];
}

export interface ListedFile {
  name: string;
  size: number;
  time: string;
}

export interface MeasuredTimes {
  machine: string;
  threads: number;
  times: ReportTime[];
}

export interface MixedLight {
  name: string;
  factor: Vec3;
  pointers: string[];
}

export interface MotionPaths {
  camera: [number, number] | null[];
  thing: [number, number] | null[];
  step: number;
}

export interface Notice {
  id: number;
  kind: string;
  text: string;
}

export interface Outline {
  revision: number;
  camera: OutlineNode;
  render: OutlineNode;
  background: OutlineNode;
  environment: OutlineNode;
  ambient: OutlineNode;
  shapes: OutlineNode[];
  lights: OutlineNode[];
  materials: OutlineNode[];
  textures: OutlineNode[];
  objects: OutlineNode[];
  idle: Record<string, string>;
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

export interface PickResult {
  pointer: string | null;
  distance: number | null;
  position: Vec3 | null;
  normal: Vec3 | null;
  material: string | null;
}

export interface PictureComparison {
  rmse: number;
  largestDifference: number;
  largestX: number;
  largestY: number;
  flip: number;
}

export interface PictureFormat {
  value: string;
  label: string;
  hasDepth: boolean;
  hasLayers: boolean;
  hasAlpha: boolean;
  isFilm: boolean;
}

export interface PixelMask {
  width: number;
  height: number;
  runs: number[];
}

export interface PixelReading {
  x: number;
  y: number;
  letters: string;
  values: (number | null)[];
}

export interface PixelSummary {
  samples: number;
  mean: number;
  noise: number;
  lights: LightShare[];
  things: LightShare[];
  depths: LightShare[];
  techniques: LightShare[];
  advice: string;
}

export interface PlacedDiagnostic {
  line: number;
  column: number;
  from: number;
  to: number;
  severity: string;
  message: string;
}

export interface PropertyValues {
  pointer: string;
  type: string | null;
  family: string | null;
  value: Json;
  effective: Record<string, Json>;
  from: number;
  to: number;
}

export interface RecoveryEntry {
  id: string;
  name: string;
  time: string;
  isFilm: boolean;
}

export interface RefractiveIndex {
  name: string;
  value: number;
}

export type RenderQuality = "draft" | "good" | "final";

export interface RenderState {
  status: string;
  width: number;
  height: number;
  samples: number;
  samplesTotal: number;
  raysPerSecond: number;
  seconds: number;
  secondsLeft: number | null;
  noise: number | null;
  threads: number;
  cores: number;
  map: string;
  region: number[] | null;
  quality: RenderQuality | null;
  isPreview: boolean;
  badSamples: number;
  filtersMotion: boolean;
  legend: string | null;
  edition: string;
  editions: string[];
}

export interface ReportTime {
  scene: number;
  figure: string;
  width: number;
  samples: number;
  reportSeconds: number;
  seconds: number;
  factor: number;
}

export interface Snapshot {
  id: number;
  name: string;
  samples: number;
  time: string;
  label: string;
  document: number;
}

export interface StudioState {
  version: number;
  document: DocumentStatus;
  selection: string | null;
  selected: string[];
  hidden: string[];
  locked: string[];
  render: RenderState;
  tone: ToneState;
  view: ViewStatus;
  snapshots: Snapshot[];
  recovery: RecoveryEntry[];
  message: Notice | null;
  lights: MixedLight[] | null;
  jobs: Job[];
  time: TimeState;
}

export interface TimeState {
  frame: number | null;
  shown: number | null;
  frames: number;
  framesPerSecond: number;
  isPlaying: boolean;
  hasVideo: boolean;
  isRecording: boolean;
  complaint: string | null;
  values: AnimatedValue[];
}

export interface TimelineKey {
  frame: number;
  ease: string;
  value: Json;
}

export interface TimelineRow {
  keys: string;
  label: string;
  pointer: string;
  thing: string;
  isMotion: boolean;
  items: TimelineKey[];
}

export interface TimelineRows {
  rows: TimelineRow[];
}

export type ToneMap = "clamp" | "soft" | "reinhard" | "aces" | "agx";

export interface ToneState {
  exposure: number;
  rule: ExposureRule;
  toneMap: ToneMap;
  choices: ToneMap[];
  rules: ExposureRule[];
}

export interface TreeStep {
  lines: Vec3[][];
  tests: number;
}

export interface TreeWalk {
  tree: string;
  shapes: number;
  visits: number;
  tests: number;
  start: Vec3;
  end: Vec3;
  isHit: boolean;
  steps: TreeStep[];
}

export interface TypeCatalogue {
  schema: Json;
  types: Record<string, CatalogueType[]>;
  sections: Record<string, CatalogueType>;
  refractiveIndices: RefractiveIndex[];
  colors: Record<string, string>;
  maps: ViewMap[];
}

export interface ViewBookmark {
  id: number;
  name: string;
  pose: CameraPose;
}

export interface ViewMap {
  name: string;
  isLight: boolean;
  title: string;
  why: string;
  scale: Vec3[];
}

export interface ViewStatus {
  pose: CameraPose | null;
  isSceneCamera: boolean;
  picture: number;
  bookmarks: ViewBookmark[];
}

export type WayFactor = "cameraPart" | "cameraBsdf" | "lens" | "geometry" | "left" | "kernel" | "lightBsdf" | "lightPart" | "radiance" | "pdf" | "paths" | "filter";

export interface WireShape {
  pointer: string | null;
  lines: Vec3[][];
}

export interface WireframeView {
  shapes: WireShape[];
  camera: CameraFrame;
}
