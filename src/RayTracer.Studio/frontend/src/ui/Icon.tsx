/** Icons of 16 × 16, drawn as lines in the colour of the text; every face of the session shares them. */

import paths from "../../../../RayTracer.Session/Texts/icons.json";

export const icons = paths;
export type IconName = keyof typeof paths;

export function Icon({ name }: { name: IconName }) {
  return (
    <svg class="icon" viewBox="0 0 16 16" width="16" height="16" aria-hidden="true" focusable="false">
      <path d={paths[name]} />
    </svg>
  );
}
