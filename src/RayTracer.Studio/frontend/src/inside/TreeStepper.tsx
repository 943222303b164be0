import { texts } from "../texts";
import { Button } from "../ui/Button";
import { Select } from "../ui/Select";
import { step, tree, walk } from "./paths";

const t = texts.trees;

/** Goes through the nodes of a tree that a ray visits, one by one. */
export function TreeStepper() {
  const now = walk.value;
  const last = now ? now.steps.length : 0;
  const go = (to: number) => (step.value = Math.min(last, Math.max(0, to)));
  const tests = now ? (now.steps[step.value]?.tests ?? now.tests) : 0;
  return (
    <div class="tree-stepper">
      <p class="quiet">{t.how}</p>
      <Select label={t.tree} value={tree.value} choices={[{ value: "", label: t.none }, ...Object.entries(t.names).map(([value, label]) => ({ value, label }))]} onChange={(name) => (tree.value = name)} />
      {now && (
        <>
          <div class="pair" role="group" aria-label={t.steps}>
            <Button label={t.back} icon="previous" disabled={step.value === 0} onClick={() => go(step.value - 1)} />
            <input type="range" aria-label={t.node} min={0} max={last} value={step.value} onInput={(e) => go(Number(e.currentTarget.value))} />
            <Button label={t.next} icon="chevron" disabled={step.value >= last} onClick={() => go(step.value + 1)} />
          </div>
          <p role="status" class="figures">{t.at(Math.min(step.value, last), last, tests)}</p>
          <p>{t.sum(now.shapes, now.visits, now.tests)} {now.isHit ? t.hit : t.miss}</p>
        </>
      )}
    </div>
  );
}
