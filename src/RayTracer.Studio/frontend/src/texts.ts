/**
 * Every text of the window, in one place. Another language is another object of this shape, added to `languages`;
 * names of parameters and what they mean come from the server, with the scene format.
 */

const english = {
  language: "English",
  product: "Studio",
  untitled: "Untitled scene",

  groups: { file: "File", edit: "Edit", view: "View", camera: "Camera", render: "Rendering", tools: "Tools", help: "Help" },

  /** Commands: name, and what it is for. */
  commands: {
    new: ["New scene", "Start with a floor, a ball and a lamp"],
    open: ["Open …", "Open a scene or a model from this computer"],
    gallery: ["Gallery", "The scenes that come with the program: a good place to start"],
    save: ["Save scene", "Write the scene file, with your comments and layout kept"],
    saveAs: ["Save scene as …", "Write the scene to another file"],
    export: ["Export picture …", "Write the picture as PNG, OpenEXR or PFM, with layers if you like"],
    copyImage: ["Copy picture", "Put the picture on the clipboard, as you see it"],
    copyCommand: ["Copy command line", "Put the command that renders exactly this on the clipboard"],
    bundle: ["Share bundle", "Download a zip of the scene and every file that it names"],
    undo: ["Undo", "Take back the last change; every step since opening is kept"],
    redo: ["Redo", "Do again what was taken back"],
    duplicate: ["Duplicate", "Make a copy of the selected thing"],
    delete: ["Delete", "Remove the selected thing from the scene"],
    rename: ["Rename …", "Give the selected thing another name; what refers to it follows"],
    deselect: ["Select nothing", "Let go of the selection"],
    pause: ["Pause or continue", "Pausing leaves the processor to you; nothing rendered is lost"],
    stop: ["Stop", "End this rendering and keep the picture so far"],
    restart: ["Render anew", "Throw the samples away and start again"],
    home: ["Camera back to start", "Put the camera where the scene file had it when it was opened"],
    fit: ["Fit picture to window", "Show the whole picture"],
    actualSize: ["Picture 1:1", "One pixel of the picture for each pixel of the screen"],
    zoomIn: ["Enlarge picture", "Look at single pixels; the camera stays"],
    zoomOut: ["Reduce picture", "The camera stays"],
    snapshot: ["Keep for comparison", "Keep this picture, to wipe between it and later ones"],
    toolSelect: ["Look and select", "Drag to orbit, click to select"],
    toolMove: ["Move", "Drag the arrows to move the selected shape"],
    toolRotate: ["Rotate", "Drag the rings to turn the selected shape"],
    toolScale: ["Scale", "Drag the handles to change the selected shape's size"],
    toolFocus: ["Focus", "Click what shall be sharp: sets the lens's focus distance"],
    toolInspect: ["Inspect a pixel", "Click a pixel to see how its light came about"],
    toolRegion: ["Render region", "Drag a rectangle: only it is rendered, and so gets clean sooner"],
    showScene: ["Scene and files pane", "Show or hide the left pane"],
    showPanel: ["Properties pane", "Show or hide the right pane"],
    showDock: ["Source and insight pane", "Show or hide the lower pane"],
    source: ["Source", "The scene file's text"],
    inside: ["Look inside", "Light paths, heat maps, convergence, times"],
    theme: ["Light or dark", "Switch the window's colours: as the system has it, light, dark"],
    shortcuts: ["Keyboard shortcuts", "All keys on one sheet"],
    tour: ["Tour", "Five steps around the window"],
  } satisfies Record<string, readonly [string, string]>,

  toolbar: { label: "Main toolbar", file: "File", add: "Add", addWhy: "Put a new thing in front of the camera", save: "Save", more: "More commands" },
  families: { shape: "Shape", light: "Light", environment: "Environment", material: "Material", texture: "Texture" } as Record<string, string>,

  left: { label: "Scene and files", scene: "Scene", gallery: "Gallery", files: "Files" },
  outliner: {
    label: "Things in the scene",
    camera: "Camera", render: "Rendering", background: "Background", environment: "Environment", ambient: "Ambient light", objects: "Objects",
    shapes: "Shapes", lights: "Lights", materials: "Materials", textures: "Textures",
    filter: "Find by name or type", empty: "none", shines: "shines",
    nothingFound: "Nothing has that name or type.",
  },
  gallery: { label: "Scenes that come with the program", loading: "Looking for scenes …", open: (name: string) => `Open ${name}` },
  files: {
    label: "Recent files", open: "Open a file …", drop: "Or drop a scene, model or zip file anywhere in the window.",
    recent: "Recent", noRecent: "Files that you open or save will be listed here.",
    dropHere: "Drop to open", dropping: (name: string) => `Opening ${name} …`,
  },

  right: { label: "Properties", object: "Object", camera: "Camera", render: "Render", world: "World" },
  panel: {
    nothing: "Nothing is selected. Click something in the picture or in the list.",
    required: "required", unit: (unit: string) => `in ${unit}`, range: (range: string) => `Allowed: ${range}`,
    reset: (key: string) => `Reset ${key} to its default`, resetWhy: "Back to the default: the value is taken out of the file",
    inPlace: "In place", named: "By name", noneYet: "not set", set: "Set", number: "value", plainColor: "colour",
    noEnvironment: "none: the background colour", environmentWhy: "Light from all around, in place of the background colour", edit: (name: string) => `Edit ${name}`,
    color: (key: string) => `${key}: colour`, channels: ["red", "green", "blue"], axes: ["x", "y", "z"], pair: ["first", "second"],
    linear: "Linear numbers: 1 is white. Names and #rrggbb are decoded as a browser does.",
    colorName: (key: string) => `${key}: name of a colour, or #rrggbb`,
    refractiveIndex: "Substance", own: "own number", choose: "Choose …", step: (n: number) => `Step ${n}`, addStep: (key: string) => `Add to ${key}`,
    removeStep: (n: number) => `Remove step ${n}`, item: (n: number) => `Number ${n}`,
    inText: "Long list: edit it in the source.", show: "Show in the source", type: "Type", slider: (key: string) => `${key}, slider`,
    drag: "Drag to change; Shift for coarse, Alt for fine steps. Arrow keys work too.",
    on: "on", off: "off", cannotRead: "This cannot be shown while the text has an error.",
  },
  render: {
    quality: "Quality", draft: "Draft", good: "Good", final: "Final",
    written: "As written",
    draftWhy: "16 samples a pixel: to arrange things", goodWhy: "256 samples a pixel: to judge the light", finalWhy: "1,024 samples a pixel: to print", writtenWhy: "As many samples as the scene file says",
    size: "Size", ownSize: "as written", threads: "Threads", threadsWhy: "One core is left free by default, so that the window stays quick",
    more: "Details",
  },

  viewport: {
    label: "Picture", canvas: "Rendered picture. Arrow keys orbit, Shift and arrows pan, plus and minus move nearer and farther, W A S D fly.",
    toolbar: "Picture tools", tools: "Tools", exposure: "Exposure", exposureWhy: "Stops by which the picture is shown brighter; nothing is rendered again",
    toneMap: "Tone map", toneMapWhy: "How bright light is fitted to the screen; nothing is rendered again",
    map: "Show", mapWhy: "The light, or what the renderer knows about each pixel",
    zoom: "Zoom", zoomWhy: "How large a pixel of the picture is on the screen", compare: "Compare with", compareWhy: "Wipe between this picture and one that you kept", noCompare: "no comparison",
    wipe: "Wipe position", region: "Region", clearRegion: "Render the whole picture again", preview: "preview",
    gizmo: "Handles of the selected shape", keptPicture: "The kept picture", inspected: (x: number, y: number) => `Pixel ${x}, ${y}`,
    lastGood: "The text has an error: this is the last good picture.",
    move: "Move along", rotate: "Rotate about", scale: "Scale along", all: "all axes", free: "Move across the picture",
  },
  maps: {
    light: ["Light", "The picture itself."],
    denoised: ["Denoised", "The light without most of its noise: smoother, but no longer exact. It takes some more time."],
    samples: ["Samples", "How many samples each pixel has: all alike, unless a region is rendered."],
    variance: ["Variance", "Where the noise is. Bright pixels need more samples: caustics, soft shadows, glossy metal."],
    bvhCost: ["Tree cost", "Nodes visited and triangles tested until the nearest hit is found: what a ray costs. Only meshes stand in trees."],
    depth: ["Depth", "Distance from the eye: white is near, black is far."],
    normal: ["Normals", "The direction that each surface faces: x as red, y as green, z as blue."],
    albedo: ["Albedo", "The colour of the surfaces without any light or shadow."],
    uv: ["uv", "Surface coordinates, by which textures are laid on: u as red, v as green."],
    primitive: ["Primitives", "Each shape or triangle in a colour of its own."],
  } as Record<string, readonly [string, string]>,

  dock: { label: "Source and insight", source: "Source", paths: "Light paths", maps: "Heat maps", convergence: "Convergence", times: "Times" },
  editor: {
    label: "Scene source", problems: "Problems", fine: "No problems", at: (line: number, column: number) => `Line ${line}, column ${column}`,
    goTo: "Go to",
    byDefault: (value: string) => `Default: ${value}`, count: (n: number) => (n === 1 ? "1 problem" : `${n} problems`),
  },
  paths: {
    label: "Light paths of a pixel", none: "No pixel chosen yet.", how: "Choose the Inspect tool (6) and click a pixel of the picture, or type its place:",
    x: "x", y: "y", show: "Show paths", sample: "Sample", event: "Event", thing: "Thing, material", weight: "Weight", throughput: "Throughput",
    pdf: "pdf (1/sr)", contribution: "Contribution", total: "Sum = radiance of the sample", pixel: (x: number, y: number) => `Pixel ${x}, ${y}`,
    mean: "Mean of all samples so far", more: "Next samples", fewer: "Previous samples", view: "Paths in the scene; drag or use the arrow keys to look around",
    table: "Vertices of the path", delta: "no choice", list: "Samples", radiance: "Radiance", explain: "Weight is what the light is multiplied by at the hit; throughput is the product of all weights before; contribution is throughput times the light found here.",
    events: { camera: "camera", diffuse: "diffuse", specular: "specular", emission: "emission", miss: "miss", absorbed: "absorbed", end: "ends" } as Record<string, string>,
    eventsWhy: {
      camera: "The ray starts at the eye", diffuse: "Scattered by a matt surface", specular: "Mirrored or refracted", emission: "Hit something that shines",
      miss: "Hit nothing: the background", absorbed: "No light is left", end: "The depth limit is reached",
    } as Record<string, string>,
    parts: (emitted: string, ambient: string, direct: string) => `Emitted ${emitted}; ambient ${ambient}; direct ${direct}`,
  },
  heat: { label: "What to show in the picture" },
  convergence: {
    label: "Error of the picture against samples", error: "error", theory: "theory: slope −1/2", samples: "samples a pixel", rmse: "RMS error",
    waiting: "The plot needs a few samples. Let it render.", slope: (s: string) => `Measured slope ${s}`,
    explain: "Both axes are logarithmic. Independent samples halve the error when their number is quadrupled: a slope of −1/2. Stratified samplers can be steeper.",
  },
  times: { label: "The report's times beside this machine's", run: "Measure now", running: "Measuring …", figure: "Figure", settings: "Settings", report: "The report", here: "This machine", ratio: "Faster",
    setting: (size: number, samples: number) => `${size} × ${size}, ${samples} samples`, milliseconds: (n: string) => `${n} ms`, times: (n: string) => `${n} ×`,
    explain: "The report's times (2009) are those of a Core 2 Duo laptop with 1.83 GHz. Here a few samples are rendered with all threads, and their time is multiplied." },

  status: {
    unsaved: "unsaved changes",
    label: "Status", samples: (n: number, total: number) => `${n} of ${total} samples`, rays: (n: string) => `${n}rays/s`, noise: (n: string) => `noise ${n} %`,
    left: (time: string) => `${time} left`, took: (time: string) => `took ${time}`, threads: (n: number, cores: number) => `${n} of ${cores} threads`,
    bad: (n: number) => `${n} bad samples left out`, size: (w: number, h: number) => `${w} × ${h}`, progress: "Progress of the rendering",
    noiseWhy: "Relative standard error of the mean, averaged over the pixels", raysWhy: "Rays traced a second, with those to the lamps",
    badWhy: "Samples that were infinite or not a number; docs: Why is my picture black?",
    states: { rendering: "rendering", paused: "paused", stopped: "stopped", done: "done", idle: "idle" } as Record<string, string>,
    cancel: "Cancel",
  },

  dialogs: {
    ok: "OK", cancel: "Cancel", close: "Close", open: "Open", save: "Save", discard: "Don't save", up: "Parent folder", folder: "Folder", fileName: "File name",
    openTitle: "Open a scene or model", saveTitle: "Save scene as", exportTitle: "Export picture", renameTitle: "Rename", newName: "New name",
    emptyFolder: "No scenes or models in this folder.", emptyOfNamed: "No pictures or models in this folder.", path: "Path", go: "Go", chooseTitle: "Choose a file",
    unsavedTitle: "Save your changes first?", unsaved: (name: string) => `${name} has changes that are not saved yet. They would be lost.`,
    overwriteTitle: "Replace the file?", replace: "Replace",
    format: "Format", bits: "Bits a channel", layers: "Layers (OpenEXR)", exportTo: "Write to file", download: "Download", formatWhy: "PNG holds what you see; OpenEXR and PFM hold linear light, for work in other programs.",
  },
  formats: { png: "PNG", exr: "OpenEXR", pfm: "PFM" } as Record<string, string>,

  empty: { title: "Render a scene", hint: "Pick one to start with, open a file, or drop one here.", open: "Open a file …", gallery: "Browse the gallery", new: "New scene", tour: "Take the tour" },
  recovery: { text: (name: string, time: string) => `“${name}” was not saved when the Studio ended (${time}).`, open: "Recover", discard: "Discard" },
  connection: { lost: "The Studio does not answer. Trying again …", refused: "This window is from an earlier start of the Studio. Open the Studio anew." },
  messages: {
    label: "Messages", dismiss: "Dismiss", copiedImage: "The picture is on the clipboard.", copiedCommand: (text: string) => `On the clipboard: ${text}`,
    cannotCopy: "The browser did not allow the clipboard to be used.", pageError: (text: string) => `Something in this window went wrong: ${text}`,
  },
  shortcuts: { title: "Keyboard shortcuts", mouse: "Mouse and touch in the picture", command: "Command", keys: "Keys",
    gestures: [
      ["Drag", "orbit"], ["Shift + drag, middle drag", "pan"], ["Right drag", "look around"], ["Wheel", "nearer and farther"], ["Alt + wheel", "lens: wider and narrower"],
      ["Ctrl + wheel", "enlarge the picture"], ["Space + drag", "move the enlarged picture"], ["Click", "select, focus or inspect, as the tool says"],
      ["Two fingers", "pan; pinch to come nearer"], ["Arrow keys", "orbit; with Shift pan"], ["W A S D, Q E", "fly: forward, left, back, right, down, up"], ["+ −", "nearer and farther"],
    ] as readonly (readonly [string, string])[],
  },
  tour: {
    next: "Next", back: "Back", done: "Done", skip: "Skip the tour", progress: (n: number, of: number) => `Step ${n} of ${of}`,
    steps: [
      ["The picture", "It gets cleaner while you watch. Drag in it to walk around; click something to select it."],
      ["The scene", "Everything that is in it. The tabs beside hold the gallery and your files."],
      ["Properties", "Change colours and numbers and see the picture follow. Hover over a name to read what it means."],
      ["Source and insight", "The same scene as text: each change appears here, and what you type appears there. Beside it: how the light came about."],
      ["Start here", "Open something from the gallery. Press ? for all keys; nothing you do here can break a file until you save."],
    ] as readonly (readonly [string, string])[],
  },
  panes: { left: "Width of the left pane", right: "Width of the right pane", bottom: "Height of the lower pane" },
  theme: { system: "as the system", light: "light", dark: "dark" } as Record<string, string>,
};

export type Texts = typeof english;

export const languages: Record<string, Texts> = { en: english };

export const texts: Texts = languages.en!;
