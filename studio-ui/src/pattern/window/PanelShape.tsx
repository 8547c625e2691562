import { memo, useMemo } from "react";
import type { TrimMark } from "../../api/types";
import { seamColor, seamDash } from "../../state/seam-colors";
import { lengthText, type Units } from "../../state/units";
import { at } from "../geometry/at";
import { outlineOf } from "../geometry/outline";
import { edgePath, outlinePath } from "../geometry/path";
import type { Place } from "../layout/arrangement";
import { deepest } from "../layout/placing";
import type { Panel, Point } from "../specification";
import { type Anchor, edgeLabels, nameExtent } from "./edge-labels";
import type { EdgeMark } from "./seam-marks";
import { TrimMarks } from "./TrimMarks";

interface PanelShapeProps {
  name: string;
  panel: Panel;
  place: Place;
  marks: readonly EdgeMark[];
  /** Pockets, buttons and the like on it. */
  trims: readonly TrimMark[] | undefined;
  /** Pixels per cm, in coarse steps: what fits at this scale is drawn. */
  scale: number;
  theme: "light" | "dark";
  units: Units;
  numbers: boolean;
  names: boolean;
  selected: boolean;
  onFocus: (panel: string) => void;
  onEnter: (panel: string) => void;
}

const LETTER_PX = 7.8;
const NAME_PX = 12;
const SMALLEST_NAME_PX = 8.5;
const LONGEST_GRAIN_CM = 14;

/** One panel as it lies on the sheet. Drawn anew only when it, its seams or the scale's step change. */
export const PanelShape = memo(function PanelShape(props: PanelShapeProps) {
  const {
    name,
    panel,
    place,
    marks,
    trims,
    scale,
    theme,
    units,
    numbers,
    names,
    selected,
    onFocus,
    onEnter,
  } = props;
  const { middle, room } = useMemo(() => deepest(outlineOf(panel, 0.2)), [panel]);
  const free = marks.filter((mark) => mark.seam < 0).length;
  const roomPx = 2 * room * scale;
  const namePx = Math.min(NAME_PX, (1.35 * roomPx * NAME_PX) / (LETTER_PX * name.length));
  const grain = Math.min(LONGEST_GRAIN_CM, 1.1 * room);
  const named = names && namePx >= SMALLEST_NAME_PX;
  const labels = useMemo(() => {
    if (!numbers) return [];
    const words = marks.flatMap((mark, edge) => {
      if (mark.seam < 0 || mark.length * scale < (mark.dart ? 64 : 38)) return [];
      const longer = mark.longer > 0 && mark.length * scale > 60;
      return [{ edge, text: `${mark.seam}${longer ? ` +${lengthText(mark.longer, units)}` : ""}` }];
    });
    const width = (LETTER_PX * namePx * name.length) / NAME_PX;
    return edgeLabels(panel, place, words, scale, named ? nameExtent(place, middle, scale, width, 16) : null);
  }, [panel, place, marks, scale, units, numbers, named, middle, name, namePx]);
  return (
    <>
      {/* biome-ignore lint/a11y/useSemanticElements: SVG has no button. */}
      <g
        className="panel"
        data-panel={name}
        transform={placeTransform(place)}
        role="button"
        tabIndex={0}
        aria-pressed={selected}
        aria-label={`Panel ${name}: ${panel.edges.length} edges, ${free} of them free`}
        onFocus={(event) => {
          if (event.currentTarget.matches(":focus-visible")) onFocus(name);
        }}
        onKeyDown={(event) => {
          if (event.key !== "Enter" && event.key !== " ") return;
          event.preventDefault();
          event.stopPropagation();
          onEnter(name);
        }}
      >
        <path className="cloth" d={outlinePath(panel)} data-selected={selected || undefined} />
        {marks.map((mark, edge) => (
          <path
            // biome-ignore lint/suspicious/noArrayIndexKey: an edge is its number.
            key={edge}
            className={mark.seam < 0 ? "edge free" : mark.dart ? "edge dart" : "edge sewn"}
            data-edge={edge}
            data-seam={mark.seam < 0 ? undefined : mark.seam}
            d={edgePath(panel, edge)}
            stroke={mark.seam < 0 ? undefined : seamColor(mark.seam, theme)}
            strokeDasharray={mark.seam < 0 ? undefined : seamDash(mark.seam)}
          />
        ))}
      </g>
      {/* Beside the button and not in it: its name says all of this in words. */}
      <g className="panel-words" transform={placeTransform(place)}>
        {trims !== undefined && <TrimMarks marks={trims} />}
        {named && (
          <>
            {roomPx > 60 && grain * scale > 34 && <Grain middle={middle} half={grain / 2} gap={10 / scale} />}
            <Text place={place} point={middle} className="name" size={Math.max(namePx, 8)}>
              {name}
            </Text>
          </>
        )}
        {labels.map(({ edge, text, point, anchor }) => {
          const [number, ...longer] = text.split(" ");
          return (
            <Text
              key={edge}
              place={place}
              point={point}
              anchor={anchor}
              className="number"
              size={10.5}
              fill={seamColor(at([...marks], edge).seam, theme)}
            >
              {number}
              {longer.length > 0 && <tspan className="longer"> {longer.join(" ")}</tspan>}
            </Text>
          );
        })}
      </g>
    </>
  );
});

/** A panel's frame on the sheet, which has y up. */
export function placeTransform(place: Place): string {
  const turn = place.angle === 0 ? "" : ` rotate(${place.angle})`;
  return `translate(${place.at[0]} ${place.at[1]})${turn}${place.mirrored ? " scale(-1 1)" : ""}`;
}

/** Upright text of a constant size on the screen at a point of the panel. */
export function Text({
  place,
  point,
  className,
  size,
  fill,
  anchor,
  children,
}: {
  place: Place;
  point: Point;
  className: string;
  size: number;
  fill?: string;
  anchor?: Anchor;
  children: React.ReactNode;
}) {
  const flip = place.mirrored ? -1 : 1;
  const turn = `rotate(${-flip * place.angle}deg)`;
  const transform = `translate(${at([...point], 0)}px, ${at([...point], 1)}px) ${turn} scale(calc(var(--cm-per-px) * ${flip}), calc(var(--cm-per-px) * -1))`;
  return (
    <text className={className} style={{ transform, fontSize: size, textAnchor: anchor }} fill={fill}>
      {children}
    </text>
  );
}

/** The grainline, with room for the panel's name. */
function Grain({ middle: [x, y], half, gap }: { middle: Point; half: number; gap: number }) {
  const tip = Math.min(0.8, half / 3);
  const arrow = (end: number, toward: number) =>
    `M${x - tip / 2},${end - toward * tip}L${x},${end}L${x + tip / 2},${end - toward * tip}`;
  return (
    <path
      className="grain"
      d={`M${x},${y - half}V${y - gap}M${x},${y + gap}V${y + half}${arrow(y + half, 1)}${arrow(y - half, -1)}`}
    />
  );
}
