/**
 * Every text of the window. They stand in one file, which every face of the session shares; another language is another such file, added to `languages`.
 * Names of parameters and what they mean come from the server, with the scene format.
 */

import english from "../../../RayTracer.Session/Texts/english.json";

type Words = Record<string, string>;
type Pairs = readonly (readonly [string, string])[];

/** A text with what stands in braces put in. */
export const fill = (template: string, values: Record<string, string | number>) => template.replace(/\{(\w+)\}/g, (_, key: string) => String(values[key]));

function textsOf(t: typeof english) {
  return {
    ...t,
    /** Commands: name, and what it is for. */
    commands: t.commands as unknown as Record<keyof typeof t.commands, readonly [string, string]>,
    families: t.families as Words,
    theme: t.theme as Words,
    gallery: {
      ...t.gallery,
      open: (name: string) => fill(t.gallery.open, { name }),
    },
    files: {
      ...t.files,
    },
    render: {
      ...t.render,
      editions: t.render.editions as Words,
    },
    background: {
      ...t.background,
      remove: (name: string) => fill(t.background.remove, { name }),
    },
    timeline: {
      ...t.timeline,
      of: (frames: number, seconds: string) => fill(t.timeline.of, { frames, seconds }),
      ofWhy: (rate: number) => fill(t.timeline.ofWhy, { rate }),
      keyAt: (name: string, frame: string) => fill(t.timeline.keyAt, { name, frame }),
      keysOf: (name: string) => fill(t.timeline.keysOf, { name }),
      select: (name: string) => fill(t.timeline.select, { name }),
      setKey: (key: string, frame: number) => fill(t.timeline.setKey, { key, frame }),
      removeKey: (key: string, frame: number) => fill(t.timeline.removeKey, { key, frame }),
    },
    lights: {
      ...t.lights,
      strength: (name: string) => fill(t.lights.strength, { name }),
      color: (name: string) => fill(t.lights.color, { name }),
    },
    panel: {
      ...t.panel,
      several: (n: number) => fill(t.panel.several, { n }),
      unit: (unit: string) => fill(t.panel.unit, { unit }),
      range: (range: string) => fill(t.panel.range, { range }),
      reset: (key: string) => fill(t.panel.reset, { key }),
      idle: (keys: string) => fill(t.panel.idle, { keys }),
      edit: (name: string) => fill(t.panel.edit, { name }),
      color: (key: string) => fill(t.panel.color, { key }),
      colorName: (key: string) => fill(t.panel.colorName, { key }),
      step: (n: number) => fill(t.panel.step, { n }),
      addStep: (key: string) => fill(t.panel.addStep, { key }),
      removeStep: (n: number) => fill(t.panel.removeStep, { n }),
      item: (n: number) => fill(t.panel.item, { n }),
      slider: (key: string) => fill(t.panel.slider, { key }),
    },
    outliner: {
      ...t.outliner,
      hide: (name: string) => fill(t.outliner.hide, { name }),
      show: (name: string) => fill(t.outliner.show, { name }),
      lock: (name: string) => fill(t.outliner.lock, { name }),
      unlock: (name: string) => fill(t.outliner.unlock, { name }),
    },
    viewport: {
      ...t.viewport,
      hidden: (n: number) => fill(t.viewport.hidden, { n }),
      addHere: (family: string) => fill(t.viewport.addHere, { family }),
      light: (name: string) => fill(t.viewport.light, { name }),
      forget: (name: string) => fill(t.viewport.forget, { name }),
      clipped: (black: string, white: string) => fill(t.viewport.clipped, { black, white }),
      inspected: (x: number, y: number) => fill(t.viewport.inspected, { x, y }),
    },
    editor: {
      ...t.editor,
      at: (line: number, column: number) => fill(t.editor.at, { line, column }),
      byDefault: (value: string) => fill(t.editor.byDefault, { value }),
      count: (n: number) => (n === 1 ? t.editor.one : fill(t.editor.count, { n })),
    },
    compare: {
      ...t.compare,
      about: (samples: number, time: string) => fill(t.compare.about, { samples, time }),
      forget: (name: string) => fill(t.compare.forget, { name }),
      differenceWhy: (largest: string, x: number, y: number) => fill(t.compare.differenceWhy, { largest, x, y }),
      ways: (["wipe", "difference", "flip"] as const).map((value) => ({ value, label: t.compare[value] })),
    },
    paths: {
      ...t.paths,
      pixel: (x: number, y: number) => fill(t.paths.pixel, { x, y }),
      parts: (emitted: string, ambient: string, direct: string) => fill(t.paths.parts, { emitted, ambient, direct }),
      open: (index: number) => fill(t.paths.open, { index }),
      shares: (light: string, scatter: string, lightPdf: string, scatterPdf: string) => fill(t.paths.shares, { light, scatter, lightPdf, scatterPdf }),
      meets: (name: string) => fill(t.paths.meets, { name }),
      survived: (chance: string) => fill(t.paths.survived, { chance }),
      passed: (left: string) => fill(t.paths.passed, { left }),
      dispersed: (color: string) => fill(t.paths.dispersed, { color }),
      blockedBy: (name: string) => fill(t.paths.blockedBy, { name }),
      noise: (noise: string, n: number) => fill(t.paths.noise, { noise, n }),
      ofNoise: (noise: string) => fill(t.paths.ofNoise, { noise }),
      openWay: (light: number, camera: number) => fill(t.paths.openWay, { light, camera }),
      outcomes: t.paths.outcomes as Words, ends: t.paths.ends as Words, techniques: t.paths.techniques as Words,
      events: t.paths.events as Words, eventsWhy: t.paths.eventsWhy as Words,
    },
    trees: {
      ...t.trees,
      at: (n: number, last: number, tests: number) => fill(t.trees.at, { n, last, tests }),
      sum: (shapes: number, visits: number, tests: number) => fill(t.trees.sum, { shapes, visits, tests }),
    },
    convergence: {
      ...t.convergence,
      slope: (s: string) => fill(t.convergence.slope, { s }),
    },
    status: {
      ...t.status,
      samples: (n: number, total: number) => fill(t.status.samples, { n, total }),
      rays: (n: string) => fill(t.status.rays, { n }),
      noise: (n: string) => fill(t.status.noise, { n }),
      left: (time: string) => fill(t.status.left, { time }),
      took: (time: string) => fill(t.status.took, { time }),
      threads: (n: number, cores: number) => fill(t.status.threads, { n, cores }),
      bad: (n: number) => fill(t.status.bad, { n }),
      pixel: (x: number, y: number) => fill(t.status.pixel, { x, y }),
      size: (w: number, h: number) => fill(t.status.size, { w, h }),
      states: t.status.states as Words,
    },
    dialogs: {
      ...t.dialogs,
      unsaved: (name: string) => fill(t.dialogs.unsaved, { name }),
    },
    connection: {
      ...t.connection,
      unsent: (name: string, time: string) => fill(t.connection.unsent, { name, time }),
      openFirst: (name: string) => fill(t.connection.openFirst, { name }),
    },
    opening: {
      ...t.opening,
      title: (name: string) => fill(t.opening.title, { name }),
      reading: (name: string) => fill(t.opening.reading, { name }),
      nothing: (name: string) => fill(t.opening.nothing, { name }),
    },
    recovery: {
      ...t.recovery,
      text: (name: string, time: string) => fill(t.recovery.text, { name, time }),
      film: (name: string, time: string) => fill(t.recovery.film, { name, time }),
    },
    messages: {
      ...t.messages,
      copiedCommand: (text: string) => fill(t.messages.copiedCommand, { text }),
      copiedCommandOfScene: (text: string) => fill(t.messages.copiedCommandOfScene, { text }),
      pageError: (text: string) => fill(t.messages.pageError, { text }),
    },
    help: {
      ...t.help,
      found: (n: number) => fill(t.help.found, { n }),
    },
    shortcuts: {
      ...t.shortcuts,
      gestures: t.shortcuts.gestures as unknown as Pairs,
    },
    tour: {
      ...t.tour,
      progress: (n: number, of: number) => fill(t.tour.progress, { n, of }),
      steps: t.tour.steps as unknown as Pairs,
    },
  };
}

export type Texts = ReturnType<typeof textsOf>;

export const languages: Record<string, Texts> = { en: textsOf(english) };

export const texts: Texts = languages.en!;
