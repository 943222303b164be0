import { post } from "../api/client";
import { duration, format, withPrefix } from "../json/numbers";
import { attempt } from "../state/messages";
import { connection, documentState, jobs, renderState } from "../state/store";
import { bottomOpen, bottomTab } from "../state/settings";
import { texts } from "../texts";
import { reading } from "../viewport/reading";
import { Button } from "../ui/Button";

const t = texts.status;

function Jobs() {
  return (
    <>
      {(jobs.value ?? []).map((job) => (
        <span class="job" key={job.id}>
          {job.text}
          <progress aria-label={job.text} value={job.fraction ?? undefined} max={1} />
          <Button label={`${t.cancel}: ${job.text}`} icon="close" onClick={() => attempt(() => post("job/cancel", { id: job.id }))} />
        </span>
      ))}
    </>
  );
}

/** The numbers of the pixel under the pointer, in linear light or as the map has them. */
function Reading() {
  const { x, y, letters, values } = reading.value!;
  return (
    <span class="reading" data-tip={t.readingWhy}>
      {t.pixel(x, y)}
      {[...letters].map((letter, i) => <span key={letter}> <b>{letter}</b> {values[i] == null ? "–" : format(values[i], 4)}</span>)}
    </span>
  );
}

/** The row at the bottom: how far the rendering is, and what is wrong with the text. */
export function StatusBar() {
  const render = renderState.value;
  const problems = documentState.value?.diagnostics.length ?? 0;
  const showProblems = () => {
    bottomOpen.value = true;
    bottomTab.value = "source";
  };
  if (connection.value === "lost" || connection.value === "refused") {
    // What was known of the rendering is no longer true.
    return <footer class="status" role="contentinfo" aria-label={t.label}><span class="state lost" role="status">{t.notConnected}</span></footer>;
  }
  return (
    <footer class="status" role="contentinfo" aria-label={t.label}>
      {render && render.width > 0 && (
        <>
          <span class={`state ${render.status}`} role="status">{t.states[render.status]}</span>
          <progress aria-label={t.progress} value={render.samples} max={Math.max(1, render.samplesTotal)} />
          <span>{t.samples(render.samples, render.samplesTotal)}</span>
          {render.raysPerSecond > 0 && <span class="rays" data-tip={t.raysWhy}>{t.rays(withPrefix(render.raysPerSecond))}</span>}
          {render.noise !== null && <span data-tip={t.noiseWhy}>{t.noise(format(render.noise * 100, 2))}</span>}
          <span>{render.secondsLeft !== null && render.status === "rendering" ? t.left(duration(render.secondsLeft)) : t.took(duration(render.seconds))}</span>
          {render.badSamples > 0 && <span class="warning" data-tip={t.badWhy}>{t.bad(render.badSamples)}</span>}
        </>
      )}
      <span class="spring" />
      <Jobs />
      {reading.value && <Reading />}
      {render && render.width > 0 && !reading.value && (
        <>
          <span>{t.size(render.width, render.height)}</span>
          <span data-tip={texts.render.threadsWhy}>{t.threads(render.threads, render.cores)}</span>
        </>
      )}
      <button type="button" class={`link ${problems ? "error" : ""}`} onClick={showProblems}>{problems ? texts.editor.count(problems) : texts.editor.fine}</button>
    </footer>
  );
}
