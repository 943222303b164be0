/** The pixel that is looked at, or the page of the help, stands in the address, so that a link opens the same view. */

import { effect } from "@preact/signals";
import { targetOf } from "../help/links";
import { helpAt, inspectedPixel, tool } from "../state/store";
import { inspect } from "../viewport/clicks";
import { picture } from "../viewport/stage";
import { chosenSample, showSample } from "./paths";
import { readAddress, writeAddress } from "./pixelAddress";

function openHelp(): void {
  const target = targetOf(location.hash);
  if (target.kind === "page") helpAt.value = { page: target.page, section: target.section };
}

function openPixel(): void {
  const wanted = readAddress(location.hash);
  if (!wanted || wanted.x >= picture.peek().width || wanted.y >= picture.peek().height) return;
  tool.value = "inspect";
  inspect({ x: wanted.x, y: wanted.y });
  showSample(wanted.sample);
}

function write(): void {
  const [help, pixel] = [helpAt.value, inspectedPixel.value];
  if (help) history.replaceState(null, "", `#help=${help.page}${help.section ? `&section=${help.section}` : ""}`);
  else if (pixel) history.replaceState(null, "", writeAddress({ ...pixel, sample: chosenSample.value }));
  else if (location.hash) history.replaceState(null, "", location.pathname);
}

/** Opens what the address names, a pixel as soon as there is a picture, and keeps the address up to date. */
export function followAddress(): void {
  openHelp();
  const stop = effect(() => {
    if (picture.value.width === 0 && helpAt.value === null) return;
    queueMicrotask(() => {
      stop();
      openPixel();
      effect(write);
    });
  });
  addEventListener("hashchange", () => (openHelp(), openPixel()));
}
