/** Icons of the pattern window: strokes on a 20 by 20 grid, in the colour of the text. */

const PATHS = {
  select: "M5 3l10.5 6.5-4.6 1L8.5 15.5z",
  point: "M3 15C7 15 9 5 17 5M10 7.2v5.6M7.2 10h5.6",
  sew: "M3 6h14M3 14h14M6 6v8M10 6v8M14 6v8",
  pan: "M10 3v14M3 10h14M10 3 8 5M10 3l2 2M10 17l-2-2M10 17l2-2M3 10l2-2M3 10l2 2M17 10l-2-2M17 10l-2 2",
  mirror: "M10 3v14M7.5 6 3 14h4.5zM12.5 6 17 14h-4.5z",
  snap: "M5 3v6a5 5 0 0 0 10 0V3M5 6h3M12 6h3M8 3v6a2 2 0 0 0 4 0V3",
  hem: "M4 4l-1 9M16 4l1 9M3 13c4 3.5 10 3.5 14 0M10 7v5M8 10l2 2 2-2",
  tidy: "M3 3.5h6v7H3zM11 3.5h6v4h-6zM11 9.5h6v7h-6zM3 12.5h6v4H3z",
  numbers: "M4 7h3v8M4 15h6M12 7.5c0-2 4-2 4 .5 0 1.5-4 4-4 6.5h4.5",
} as const;

export type PatternIconName = keyof typeof PATHS;

export function PatternIcon({ name }: { name: PatternIconName }) {
  return (
    <svg className="icon" width={18} height={18} viewBox="0 0 20 20" aria-hidden="true" focusable="false">
      <path d={PATHS[name]} />
    </svg>
  );
}
