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
