/** Icons drawn for the studio: strokes on a 20 by 20 grid, in the colour of the text. */

const PATHS = {
  undo: "M7 5 3.5 8.5 7 12M4 8.5h8a4 4 0 0 1 0 8H8",
  redo: "M13 5l3.5 3.5L13 12M16 8.5H8a4 4 0 0 0 0 8h4",
  open: "M2.5 15.5v-11h5l2 2h8v9zM2.5 9h15",
  save: "M4 3.5h9l3.5 3.5v9.5H4zM7 3.5v4h5v-4M6.5 16.5v-5h7v5",
  download: "M10 3v9.5M6 9l4 4 4-4M3.5 16.5h13",
  compare: "M3 4.5h5.5v11H3zM11.5 4.5H17v11h-5.5z",
  help: "M7.5 7.5a2.5 2.5 0 1 1 3.5 2.3c-.7.35-1 .8-1 1.7M10 14.2v.3",
  light:
    "M10 6.8a3.2 3.2 0 1 0 0 6.4 3.2 3.2 0 0 0 0-6.4M10 2v2M10 16v2M2 10h2M16 10h2M4.4 4.4l1.4 1.4M14.2 14.2l1.4 1.4M4.4 15.6l1.4-1.4M14.2 5.8l1.4-1.4",
  dark: "M16 11.5A6.5 6.5 0 0 1 8.5 4a6.5 6.5 0 1 0 7.5 7.5z",
  picture: "M3 4.5h14v11H3zM3 13l4-4 3.5 3.5L13 10l4 4M13 7.5v.1",
  dice: "M4 4h12v12H4zM7.2 7.2v.1M12.8 7.2v.1M10 10v.1M7.2 12.8v.1M12.8 12.8v.1",
  close: "M5 5l10 10M15 5 5 15",
  check: "M4.5 10.5 8 14l7.5-8",
  warning: "M10 3.5 17.5 16.5h-15zM10 8.5v3.5M10 14.2v.1",
  error: "M10 2.8a7.2 7.2 0 1 0 0 14.4 7.2 7.2 0 0 0 0-14.4M10 6.5v4.5M10 13.4v.1",
  info: "M10 2.8a7.2 7.2 0 1 0 0 14.4 7.2 7.2 0 0 0 0-14.4M10 9v4.5M10 6.5v.1",
  body: "M10 2.5a2 2 0 1 0 0 4 2 2 0 0 0 0-4M6 8.5c1.2-1 6.8-1 8 0l1 4-1.6.4L12.5 11v6.5h-5V11l-.9 1.9L5 12.5z",
  wire: "M3 6.5 10 3l7 3.5v7L10 17l-7-3.5zM3 6.5l7 3.5 7-3.5M10 10v7M3 13.5l7-3.5 7 3.5",
  normals: "M3 15.5c4-2.5 10-2.5 14 0M10 13.5V4M7.5 6.5 10 4l2.5 2.5M4.5 12.5 3 8M15.5 12.5 17 8",
  seam: "M3 13c3 0 4-6 7-6s4 6 7 6M3 17h2M7 17h2M11 17h2M15 17h2",
  sidebar: "M3 4h14v12H3zM8 4v12",
  chevron: "M6 8l4 4 4-4",
  fit: "M3.5 7.5v-4h4M12.5 3.5h4v4M16.5 12.5v4h-4M7.5 16.5h-4v-4",
  trash: "M4 5.5h12M8 5.5v-2h4v2M5.5 5.5l.7 11h7.6l.7-11",
  plus: "M10 4v12M4 10h12",
  lock: "M5 9h10v7.5H5zM7 9V6.5a3 3 0 0 1 6 0V9",
  unlock: "M5 9h10v7.5H5zM7 9V6.5a3 3 0 0 1 5.8-1",
  stop: "M5.5 5.5h9v9h-9z",
  wave: "M2.5 7c2.5-3 5-3 7.5 0s5 3 7.5 0M2.5 13c2.5-3 5-3 7.5 0s5 3 7.5 0",
  sparkle: "M10 3l1.7 5.3L17 10l-5.3 1.7L10 17l-1.7-5.3L3 10l5.3-1.7z",
} as const;

export type IconName = keyof typeof PATHS;

export function Icon({ name, size = 18 }: { name: IconName; size?: number }) {
  return (
    <svg className="icon" width={size} height={size} viewBox="0 0 20 20" aria-hidden="true" focusable="false">
      <path d={PATHS[name]} />
    </svg>
  );
}
