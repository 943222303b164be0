import type { CameraFrame, InspectedPath } from "../api/types";
import { projectLine } from "../math/projection";
import { inspectedPixel, tool } from "../state/store";
import { placement, picture } from "../viewport/stage";
import { pathPoints } from "./drawScene";
import { chosenSample, drawsAll, isFollowing, litSamples, openVertex, paths, pointedVertex, wireframe } from "./paths";

const farAway = 1e4;

function Line({ sample, camera, isChosen }: { sample: InspectedPath; camera: CameraFrame; isChosen: boolean }) {
  // The first stretch is the eye's own ray: it is seen as a point.
  const points = pathPoints(sample, farAway).slice(1);
  const stretches = points.slice(1).map((b, i) => projectLine(camera, points[i]!, b));
  const marked = pointedVertex.value >= 0 ? pointedVertex.value : openVertex.value;
  return (
    <g class={isChosen ? "chosen" : ""}>
      {stretches.map((s, i) => s && <line key={i} class={i + 2 === marked ? "marked" : ""} x1={s[0].x} y1={s[0].y} x2={s[1].x} y2={s[1].y} vector-effect="non-scaling-stroke" />)}
      {isChosen && stretches.map((s, i) => s && <circle key={i} class={i + 2 === marked ? "marked" : ""} cx={s[1].x} cy={s[1].y} r={3 / placement.value.scale} vector-effect="non-scaling-stroke" />)}
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
  const shown = answer.samples.filter((s) => s.sample === chosenSample.value || (drawsAll.value && (!lit || lit.includes(s.sample))));
  return (
    <svg class="path-overlay" aria-hidden="true" viewBox={`0 0 ${camera.width} ${camera.height}`} preserveAspectRatio="none" style={{ left: `${left}px`, top: `${top}px`, width: `${width * scale}px`, height: `${height * scale}px` }}>
      {shown.map((s) => <Line sample={s} camera={camera} isChosen={s.sample === chosenSample.value} key={s.sample} />)}
    </svg>
  );
}
