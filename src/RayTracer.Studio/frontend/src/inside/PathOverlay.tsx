import type { CameraFrame, InspectedPath, Vec3 } from "../api/types";
import { project, projectLine } from "../math/projection";
import { inspectedPixel, tool } from "../state/store";
import { placement, picture } from "../viewport/stage";
import { pathPoints } from "./drawScene";
import { chosenSample, drawsAll, isFollowing, litSamples, openVertex, paths, pointedLight, pointedSample, pointedVertex, wireframe } from "./paths";

const farAway = 1e4;

interface LineProps {
  sample: InspectedPath;
  camera: CameraFrame;
  isChosen: boolean;
}

function Stretch({ camera, from, to, kind, onPoint }: { camera: CameraFrame; from: Vec3; to: Vec3; kind: string; onPoint: (isPointed: boolean) => void }) {
  const line = projectLine(camera, from, to);
  if (!line) return null;
  const ends = { x1: line[0].x, y1: line[0].y, x2: line[1].x, y2: line[1].y };
  return (
    <g onPointerEnter={() => onPoint(true)} onPointerLeave={() => onPoint(false)}>
      <line class="grip" {...ends} vector-effect="non-scaling-stroke" />
      <line class={kind} {...ends} vector-effect="non-scaling-stroke" />
    </g>
  );
}

function Line({ sample, camera, isChosen }: LineProps) {
  // The first stretch is the eye's own ray: it is seen as a point.
  const points = pathPoints(sample, farAway);
  const marked = isChosen ? (pointedVertex.value >= 0 ? pointedVertex.value : openVertex.value) : -1;
  const pointAt = (vertex: number, isPointed: boolean) => {
    if (isChosen) pointedVertex.value = isPointed ? vertex : -1;
    else pointedSample.value = isPointed ? sample.sample : -1;
  };
  const asked = isChosen ? (sample.vertices[openVertex.value]?.lights ?? []) : [];
  const scale = placement.value.scale;
  return (
    <g class={isChosen ? "chosen" : pointedSample.value === sample.sample ? "pointed" : ""}>
      {points.map((to, i) => i > 1 && <Stretch key={i} camera={camera} from={points[i - 1]!} to={to} kind={i === marked ? "marked" : ""} onPoint={(is) => pointAt(i, is)} />)}
      {asked.map((light, i) => light.point && (
        <Stretch key={`light ${i}`} camera={camera} from={points[openVertex.value]!} to={light.point} kind={`asked ${light.outcome} ${i === pointedLight.value ? "marked" : ""}`} onPoint={(is) => (pointedLight.value = is ? i : -1)} />
      ))}
      {isChosen && points.map((point, i) => {
        const at = i > 0 && project(camera, point);
        return at && (
          <g key={i} onPointerEnter={() => pointAt(i, true)} onPointerLeave={() => pointAt(i, false)}>
            <circle class="grip" cx={at.x} cy={at.y} r={9 / scale} />
            <circle class={i === marked ? "marked" : ""} cx={at.x} cy={at.y} r={(i === marked ? 5 : 3) / scale} vector-effect="non-scaling-stroke" />
          </g>
        );
      })}
    </g>
  );
}

/** The paths of the inspected pixel, over the picture. */
export function PathOverlay() {
  const [answer, camera] = [paths.value, wireframe.value?.camera];
  if (!answer || !camera || !inspectedPixel.value || !isFollowing.value || tool.value !== "inspect") return null;
  const { scale, left, top } = placement.value;
  const { width, height } = picture.value;
  const lit = litSamples.value;
  const shown = answer.samples.filter((s) => s.sample === chosenSample.value || s.sample === pointedSample.value || (drawsAll.value && (!lit || lit.includes(s.sample))));
  return (
    <svg class="path-overlay" aria-hidden="true" viewBox={`0 0 ${camera.width} ${camera.height}`} preserveAspectRatio="none" style={{ left: `${left}px`, top: `${top}px`, width: `${width * scale}px`, height: `${height * scale}px` }}>
      {shown.map((s) => <Line sample={s} camera={camera} isChosen={s.sample === chosenSample.value} key={s.sample} />)}
    </svg>
  );
}
