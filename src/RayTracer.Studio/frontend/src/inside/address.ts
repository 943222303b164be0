/** The pixel that is looked at stands in the address, so that a link opens the same view. */

import { effect } from "@preact/signals";
import { inspectedPixel, tool } from "../state/store";
import { inspect } from "../viewport/clicks";
import { picture } from "../viewport/stage";
import { chosenSample, showSample } from "./paths";
import { readAddress, writeAddress } from "./pixelAddress";

function open(): void {
  const wanted = readAddress(location.hash);
  if (!wanted || wanted.x >= picture.peek().width || wanted.y >= picture.peek().height) return;
  tool.value = "inspect";
  inspect({ x: wanted.x, y: wanted.y });
  showSample(wanted.sample);
}

/** Opens what the address names as soon as there is a picture, and keeps the address up to date. */
export function followAddress(): void {
  const stop = effect(() => {
    if (picture.value.width === 0) return;
    queueMicrotask(() => {
      stop();
      open();
      effect(() => {
        const pixel = inspectedPixel.value;
        if (pixel) history.replaceState(null, "", writeAddress({ ...pixel, sample: chosenSample.value }));
      });
    });
  });
  addEventListener("hashchange", open);
}
