/** Icons of 16 × 16, drawn as lines in the colour of the text. */

const paths = {
  open: "M2 12.5v-9h4l1.5 2H14v7z",
  save: "M2.5 2.5h8.5l2.5 2.5v8.5h-11zM5 2.5v3.5h5v-3.5M4.5 13.5v-4.5h7v4.5",
  export: "M8 9.5V2.5M5 5l3-3 3 3M2.5 9.5v4h11v-4",
  add: "M8 3v10M3 8h10",
  undo: "M5.5 3L2.5 6l3 3M2.5 6h7a3.5 3.5 0 0 1 0 7H6",
  redo: "M10.5 3l3 3-3 3M13.5 6h-7a3.5 3.5 0 0 0 0 7H10",
  play: "M4.5 3v10l8-5z",
  pause: "M5 3.5v9M11 3.5v9",
  stop: "M4 4h8v8H4z",
  restart: "M13 8a5 5 0 1 1-1.7-3.7M13.5 2v3h-3",
  fit: "M2.5 6V2.5H6M10 2.5h3.5V6M13.5 10v3.5H10M6 13.5H2.5V10",
  actual: "M3 5l1.5-1.5V12.5M11 5l1.5-1.5V12.5M8 6.5v.1M8 10v.1",
  zoomIn: "M7 2.5a4.5 4.5 0 1 1 0 9 4.5 4.5 0 0 1 0-9M10.3 10.3L14 14M7 5v4M5 7h4",
  zoomOut: "M7 2.5a4.5 4.5 0 1 1 0 9 4.5 4.5 0 0 1 0-9M10.3 10.3L14 14M5 7h4",
  home: "M2 8l6-5.5L14 8M4 6.5v7h8v-7",
  camera: "M2 5h3l1-1.5h4L11 5h3v8H2zM8 6.5a2.3 2.3 0 1 1 0 4.6 2.3 2.3 0 0 1 0-4.6",
  select: "M3.5 2.5l9 5-4 1.200-1.7 4z",
  move: "M8 1.5v13M1.5 8h13M6 3.5l2-2 2 2M6 12.5l2 2 2-2M3.5 6l-2 2 2 2M12.5 6l2 2-2 2",
  rotate: "M13 6.5A5.3 5.3 0 1 0 13.200 9M13.5 3v3.5H10",
  scale: "M2.5 8.5h5v5h-5zM9 7l4.5-4.5M10 2.5h3.5V6",
  focus: "M8 5.5a2.5 2.5 0 1 1 0 5 2.5 2.5 0 0 1 0-5M8 1.5v3M8 11.5v3M1.5 8h3M11.5 8h3",
  inspect: "M13.5 2.5l-6 6M7 5.5l3.5 3.5M8 8L3.5 12.5l-1.5.5.5-1.5L7 7",
  region: "M4.5 1.5v10h10M1.5 4.5h10v10",
  snapshot: "M2.5 3.5h11v9h-11zM8 1.5v13",
  scene: "M8 1.5l5.5 3v7L8 14.5l-5.5-3v-7zM2.5 4.5l5.5 3 5.5-3M8 7.5v7",
  sliders: "M2 4.5h6M11 4.5h3M9.5 3v3M2 11.5h3M8 11.5h6M6.5 10v3",
  code: "M5.5 4L1.5 8l4 4M10.5 4l4 4-4 4",
  theme: "M8 2.5a5.5 5.5 0 1 1 0 11zM8 2.5a5.5 5.5 0 0 0 0 11",
  help: "M8 1.800a6.200 6.200 0 1 1 0 12.400 6.200 6.200 0 0 1 0-12.400M6.200 6.3a1.800 1.800 0 1 1 2.6 1.6c-.6.3-.8.7-.8 1.400M8 11.400v.1",
  more: "M3.5 8v.1M8 8v.1M12.5 8v.1",
  close: "M4 4l8 8M12 4l-8 8",
  reset: "M4 3v3.5h3.5M4.200 6.3A5 5 0 1 1 3.5 10",
  chevron: "M6 4l4 4-4 4",
  down: "M4 6l4 4 4-4",
  sphere: "M8 2a6 6 0 1 1 0 12A6 6 0 0 1 8 2M2.5 9.5c3 2 8 2 11 0",
  light: "M8 2a4 4 0 0 1 2.200 7.3V11H5.800V9.3A4 4 0 0 1 8 2M6.3 13.5h3.400",
  material: "M8 2a6 6 0 1 1 0 12A6 6 0 0 1 8 2M5 7a3.5 3.5 0 0 1 2.5-2.5",
  texture: "M2.5 2.5h11v11h-11zM2.5 8h11M8 2.5v11",
  background: "M2 3h12v10H2zM2 11l4-4 3 3 2-2 3 3",
  render: "M2.5 3.5h11v9h-11zM5 9.5l2-2.5 1.5 1.5L10 6.5l1.5 3",
  trash: "M3 4.5h10M6 4.5v-2h4v2M4.5 4.5l.5 9h6l.5-9",
  copy: "M5.5 5.5h8v8h-8zM10.5 5.5v-3h-8v8h3",
  warning: "M8 2.5l6 11H2zM8 6.5v3.5M8 11.7v.1",
  rename: "M3 13l.8-3L10.8 3l2.2 2.2-7 7z",
  check: "M3 8.5l3.5 3.5L13 4.5",
} as const;

export type IconName = keyof typeof paths;

export function Icon({ name }: { name: IconName }) {
  return (
    <svg class="icon" viewBox="0 0 16 16" width="16" height="16" aria-hidden="true" focusable="false">
      <path d={paths[name]} />
    </svg>
  );
}
