import { expect, test } from "vitest";
import { readPlace } from "../src/help/places";
import { targetOf } from "../src/help/links";

test("A place is a page, with a section or without", () => {
  expect(readPlace("studio")).toEqual({ page: "studio" });
  expect(readPlace("scene-format#mix-1")).toEqual({ page: "scene-format", section: "mix-1" });
});

test("Links lead to pages, scenes of the gallery, sections, and away", () => {
  expect(targetOf("#help=primer/07-refraction")).toEqual({ kind: "page", page: "primer/07-refraction" });
  expect(targetOf("#help=studio&section=time")).toEqual({ kind: "page", page: "studio", section: "time" });
  expect(targetOf("#file=scenes/primer/07-refraction.json")).toEqual({ kind: "scene", galleryId: "primer/07-refraction.json" });
  expect(targetOf("#file=scenes/raytracer.schema.json").kind).toBe("file");
  expect(targetOf("#file=scenes/broken/a.json").kind).toBe("file");
  expect(targetOf("#file=src/RayTracer/RTracer.cs")).toEqual({ kind: "file", path: "src/RayTracer/RTracer.cs" });
  expect(targetOf("#the-film")).toEqual({ kind: "section", section: "the-film" });
  expect(targetOf("https://example.org/a#b").kind).toBe("web");
});

test("A lesson proposes changes of its scene", () => {
  expect(targetOf('try:camera/verticalFov=40;shapes/0/color=[1,0,0.5];textures/a/type="solid"')).toEqual({
    kind: "try",
    changes: [{ pointer: "/camera/verticalFov", value: 40 }, { pointer: "/shapes/0/color", value: [1, 0, 0.5] }, { pointer: "/textures/a/type", value: "solid" }],
  });
  expect(targetOf("try:environment=%7B%22type%22:%22sky%22%7D")).toEqual({ kind: "try", changes: [{ pointer: "/environment", value: { type: "sky" } }] });
});
