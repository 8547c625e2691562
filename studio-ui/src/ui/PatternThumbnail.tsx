import { useMemo } from "react";
import { boxMiddle, boxSize } from "../pattern/geometry/bounds";
import { outlinePath } from "../pattern/geometry/path";
import { arranged, boxOfAll } from "../pattern/layout/arrangement";
import type { PatternJson } from "../state/pattern-json";

/** The pattern's panels side by side, small. */
export function PatternThumbnail({ pattern, label }: { pattern: PatternJson; label?: string }) {
  const drawing = useMemo(() => drawn(pattern), [pattern]);
  if (drawing === null) return <div className="thumbnail empty" />;
  return (
    // biome-ignore lint/a11y/noSvgWithoutTitle: it has a label, or is hidden where text beside it says the same.
    <svg
      className="thumbnail"
      viewBox={drawing.viewBox}
      preserveAspectRatio="xMidYMid meet"
      {...(label === undefined ? { "aria-hidden": true } : { role: "img", "aria-label": label })}
    >
      {drawing.panels.map(({ name, path, transform }) => (
        <path key={name} d={path} transform={transform} vectorEffect="non-scaling-stroke" />
      ))}
    </svg>
  );
}

function drawn(pattern: PatternJson) {
  try {
    const places = arranged(pattern);
    const box = boxOfAll(pattern, places);
    const [width, height] = boxSize(box);
    const [x, y] = boxMiddle(box);
    const margin = 0.04 * Math.max(width, height);
    return {
      // The drawing's y points down, the pattern's up.
      viewBox: [
        x - width / 2 - margin,
        -y - height / 2 - margin,
        width + 2 * margin,
        height + 2 * margin,
      ].join(" "),
      panels: Object.entries(pattern.pattern.panels).map(([name, panel]) => {
        const place = places[name] ?? { at: [0, 0], angle: 0, mirrored: false };
        const [px, py] = place.at;
        return {
          name,
          path: outlinePath(panel),
          transform: `scale(1 -1) translate(${px} ${py}) rotate(${place.angle})${place.mirrored ? " scale(-1 1)" : ""}`,
        };
      }),
    };
  } catch {
    return null;
  }
}
