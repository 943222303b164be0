import { useEffect, useMemo, useRef, useState } from "preact/hooks";
import { get } from "../api/client";
import type { InspectedPath, WireframeView } from "../api/types";
import { orbitCamera } from "../math/projection";
import { length, subtract } from "../math/vec3";
import { complain } from "../state/messages";
import { isDark } from "../state/settings";
import { revision, selection } from "../state/store";
import { texts } from "../texts";
import { marksAt, SceneDrawing, type Palette } from "./drawScene";
import { chosenSample, chosenWay, litSamples, openVertex, pointedLight, pointedSample, pointedVertex, step, walk, wireframe } from "./paths";
import { around, nearer, newOrbit, turned } from "./orbit";

const palettes: Record<"light" | "dark", Palette> = {
  light: { wire: "#9aa7b4", selected: "#c26a00", camera: "#2f6fb0", faint: "#3a4552" },
  dark: { wire: "#55636f", selected: "#ffb45c", camera: "#6fb0f0", faint: "#000000" },
};

interface PathSceneProps {
  samples: InspectedPath[];
  chosen: number;
  way: number;
}

/** The scene as wires, with the paths in it; can be looked at from all sides. */
export function PathScene({ samples, chosen, way }: PathSceneProps) {
  const ref = useRef<HTMLCanvasElement>(null);
  const orbit = useMemo(newOrbit, []);
  const [size, setSize] = useState({ width: 0, height: 0 });
  const now = revision.value;

  useEffect(() => {
    get<WireframeView>("wireframe").then((answer) => {
      wireframe.value = answer;
      const points = answer.shapes.flatMap((s) => s.lines.flat());
      orbit.value ??= around([...points, answer.camera.position], answer.camera.position);
    }, complain);
  }, [now]);

  useEffect(() => {
    const canvas = ref.current!;
    const watcher = new ResizeObserver(() => setSize({ width: canvas.clientWidth, height: canvas.clientHeight }));
    watcher.observe(canvas);
    return () => watcher.disconnect();
  }, []);

  const [scene, eye, selected, dark] = [wireframe.value, orbit.value, selection.value, isDark()];
  const [lit, open, vertex, light, pointed] = [litSamples.value, openVertex.value, pointedVertex.value, pointedLight.value, pointedSample.value];
  const reach = scene && eye ? length(subtract(scene.camera.position, eye.target)) : 0;
  const [walked, shownStep] = [walk.value, step.value];
  useEffect(() => {
    const canvas = ref.current!;
    if (!scene || !eye || size.width === 0) return;
    [canvas.width, canvas.height] = [size.width * devicePixelRatio, size.height * devicePixelRatio];
    const context = canvas.getContext("2d")!;
    context.scale(devicePixelRatio, devicePixelRatio);
    context.font = "11px system-ui, sans-serif";
    const camera = orbitCamera(eye.target, eye.yaw, eye.pitch, eye.distance, size.width, size.height);
    const drawing = new SceneDrawing(context, camera, palettes[dark ? "dark" : "light"]);
    const marks = { open, vertex, light, sample: pointed };
    drawing.wires(scene, selected);
    drawing.eye(scene.camera, reach / 10);
    for (const s of samples) if (s.sample !== chosen && (!lit || lit.includes(s.sample))) drawing.path(s, false, 2 * reach, marks);
    const own = samples.find((s) => s.sample === chosen);
    if (own) drawing.path(own, true, 2 * reach, marks);
    if (walked) drawing.walk(walked, shownStep);
    const lightPart = own?.ways[way];
    if (lightPart) drawing.way(lightPart);
  }, [scene, eye, size, samples, chosen, way, selected, dark, lit, open, vertex, light, pointed, walked, shownStep]);

  const turn = (yaw: number, pitch: number) => orbit.value && (orbit.value = turned(orbit.value, yaw, pitch));
  const approach = (factor: number) => orbit.value && (orbit.value = nearer(orbit.value, factor));
  const [down, setDown] = useState({ x: 0, y: 0 });
  const at = (e: MouseEvent) => ({ x: e.offsetX, y: e.offsetY });
  const marksUnder = (e: MouseEvent) => {
    const camera = eye && orbitCamera(eye.target, eye.yaw, eye.pitch, eye.distance, size.width, size.height);
    const shown = samples.filter((s) => s.sample === chosen || !lit || lit.includes(s.sample));
    return camera && marksAt(camera, shown, chosen, open, 2 * reach, at(e));
  };
  const onPointerMove = (e: PointerEvent) => {
    if (e.buttons) return turn(-e.movementX * 0.01, e.movementY * 0.01);
    const marks = marksUnder(e);
    if (marks) [pointedVertex.value, pointedLight.value, pointedSample.value] = [marks.vertex, marks.light, marks.sample];
  };
  const onPointerLeave = () => (pointedVertex.value = pointedLight.value = pointedSample.value = -1);
  const onClick = (e: MouseEvent) => {
    const marks = marksUnder(e);
    if (!marks || Math.hypot(e.offsetX - down.x, e.offsetY - down.y) > 3) return;
    if (marks.vertex >= 0) openVertex.value = marks.vertex;
    if (marks.sample >= 0) [chosenSample.value, chosenWay.value] = [marks.sample, -1];
  };
  const onWheel = (e: WheelEvent) => {
    e.preventDefault();
    approach(2 ** (e.deltaY / 400));
  };
  const onKeyDown = (e: KeyboardEvent) => {
    const turns: Record<string, [number, number]> = { ArrowLeft: [-0.1, 0], ArrowRight: [0.1, 0], ArrowUp: [0, 0.1], ArrowDown: [0, -0.1] };
    const step = turns[e.key];
    if (step) turn(...step);
    else if (e.key === "+" || e.key === "=") approach(0.9);
    else if (e.key === "-") approach(1 / 0.9);
    else return;
    e.preventDefault();
    e.stopPropagation();
  };
  return (
    <canvas
      ref={ref}
      class="path-scene"
      role="application"
      aria-label={texts.paths.view}
      tabIndex={0}
      width={1}
      height={1}
      onPointerDown={(e) => {
        e.currentTarget.setPointerCapture(e.pointerId);
        setDown(at(e));
      }}
      onPointerMove={onPointerMove}
      onPointerLeave={onPointerLeave}
      onClick={onClick}
      onWheel={onWheel}
      onKeyDown={onKeyDown}
    />
  );
}
