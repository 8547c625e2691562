import type { TrimMark } from "../../api/types";

/** Where pockets, buttons and zips lie on a panel, in its frame. They are looked at, and not taken hold of. */
export function TrimMarks({ marks }: { marks: readonly TrimMark[] }) {
  return (
    // biome-ignore lint/a11y/noAriaHiddenOnFocusable: a group of lines cannot have the focus.
    <g className="trims" aria-hidden="true">
      {marks.map((mark, k) => (
        // biome-ignore lint/suspicious/noArrayIndexKey: marks have no id and are replaced together.
        <Mark key={k} mark={mark} />
      ))}
    </g>
  );
}

function Mark({ mark: { kind, points, radius, trim } }: { mark: TrimMark }) {
  const [first] = points;
  if (first === undefined) return null;
  if (kind === "button")
    return <circle className="button-mark" data-trim={trim} cx={first[0]} cy={first[1]} r={radius} />;
  return (
    <path className={kind} data-trim={trim} d={`M${points.join("L")}${kind === "outline" ? "Z" : ""}`} />
  );
}

/** Marks by the panel that they lie on. */
export function trimsByPanel(marks: readonly TrimMark[]): ReadonlyMap<string, readonly TrimMark[]> {
  const found = new Map<string, TrimMark[]>();
  for (const mark of marks) found.set(mark.panel, [...(found.get(mark.panel) ?? []), mark]);
  return found;
}
