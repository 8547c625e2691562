/** What is selected, in numbers that can be typed over. */

import { useEffect, useState } from "react";
import type { Target } from "../../state/selection";
import { useStudio } from "../../state/store";
import { fromCm, lengthText, toCm, unitMark } from "../../state/units";
import { Button } from "../../ui/Button";
import { type CurveKind, depthOf, kindOf, reshapeEdge, shapeOfDepth, shapeOfKind } from "../edits/bend-edge";
import { counterpartOf } from "../edits/counterpart";
import { angleOf, movesForAngle, movesForLength, movesToPlace } from "../edits/measure-edge";
import { reshapeMirrored } from "../edits/mirror";
import { movesOf } from "../edits/move-vertices";
import { renamePanel } from "../edits/rename-panel";
import { at } from "../geometry/at";
import { boxSize } from "../geometry/bounds";
import type { Shape } from "../geometry/curve";
import { curveOf, edgeLength, panelBox, signedArea } from "../geometry/outline";
import { directionToPanel } from "../layout/arrangement";
import {
  type EdgeRef,
  isRightWrong,
  type Point,
  panelOf,
  partnerIn,
  type Specification,
  stitchOf,
  type VertexRef,
} from "../specification";
import {
  addPointAt,
  deleteSelected,
  performMoves,
  removeStitches,
  rotateSelected,
  selectedEdges,
  selectedStitches,
  selectedVertices,
  sewSelected,
  sewTogether,
  turnStitchOf,
} from "./commands";
import { perform } from "./document";
import { NumberField } from "./NumberField";
import { usePatternView } from "./pattern-view-state";

const SAME_CM = 0.05;

export function Inspector({ specification }: { specification: Specification }) {
  const selection = useStudio((state) => state.selection);
  const tool = usePatternView((state) => state.tool);
  const sewFrom = usePatternView((state) => state.sewFrom);
  const vertices = selectedVertices(selection).filter((v) => v.vertex < count(specification, v.panel));
  const edges = selectedEdges(selection).filter((e) => e.edge < count(specification, e.panel));
  const panels = selection.flatMap((t) =>
    t.kind === "panel" && count(specification, t.panel) > 0 ? [t.panel] : [],
  );
  const seams = selection.flatMap((t) =>
    t.kind === "seam" && t.stitch < specification.pattern.stitches.length ? [t.stitch] : [],
  );
  return (
    <section className="inspector" aria-label="What is selected">
      {tool === "sew" ? (
        <p className="hint">
          {sewFrom === null
            ? "Choose the first free edge."
            : `Choose the edge to sew to edge ${sewFrom.edge} of ${sewFrom.panel}.`}
        </p>
      ) : tool === "point" ? (
        <p className="hint">Click on an edge to add a point. The edge it is sewn to gets one too.</p>
      ) : vertices.length === 1 && edges.length === 0 ? (
        <OneVertex {...{ specification }} vertex={at(vertices, 0)} />
      ) : vertices.length > 1 ? (
        <Several {...{ specification, vertices }} />
      ) : edges.length === 1 ? (
        <OneEdge {...{ specification }} edge={at(edges, 0)} />
      ) : edges.length > 1 ? (
        <SeveralEdges {...{ specification, edges, selection }} />
      ) : seams.length > 0 ? (
        <OneSeam {...{ specification }} number={at(seams, 0)} />
      ) : panels.length === 1 ? (
        <OnePanel {...{ specification }} name={at(panels, 0)} />
      ) : panels.length > 1 ? (
        <p className="hint">{panels.length} panels. Drag to arrange them; the garment stays as it is.</p>
      ) : (
        <p className="hint">Drag a point, an edge or a hem. Click a panel, edge or point for its measures.</p>
      )}
    </section>
  );
}

function count(specification: Specification, panel: string): number {
  return specification.pattern.panels[panel]?.vertices.length ?? 0;
}

function OneVertex({ specification, vertex }: { specification: Specification; vertex: VertexRef }) {
  const units = useStudio((state) => state.units);
  const point = at(panelOf(specification, vertex.panel).vertices, vertex.vertex);
  const place = (axis: 0 | 1) => (value: number) => {
    const to: [number, number] = [point[0], point[1]];
    to[axis] = toCm(value, units);
    performMoves(`Move point of ${vertex.panel}`, movesToPlace(specification, vertex, to));
  };
  return (
    <>
      <Title text={`Point ${vertex.vertex}`} of={vertex.panel} />
      <NumberField label="X" value={fromCm(point[0], units)} unit={unitMark(units)} onChange={place(0)} />
      <NumberField label="Y" value={fromCm(point[1], units)} unit={unitMark(units)} onChange={place(1)} />
      <Button className="small" onClick={deleteSelected} title="Delete point (Delete)">
        Delete
      </Button>
    </>
  );
}

function Several({
  specification,
  vertices,
}: {
  specification: Specification;
  vertices: readonly VertexRef[];
}) {
  const units = useStudio((state) => state.units);
  const arrangement = usePatternView((state) => state.arrangement);
  const by = (shift: Point) =>
    performMoves(
      `Move ${vertices.length} points`,
      movesOf(vertices, (name) => {
        const place = arrangement[name];
        return place === undefined ? [0, 0] : directionToPanel(place, shift);
      }),
    );
  const panels = new Set(vertices.map((v) => v.panel));
  return (
    <>
      <Title
        text={`${vertices.length} points`}
        of={panels.size === 1 ? [...panels].join() : `${panels.size} panels`}
      />
      <MoveBy label="Right by" onMove={(value) => by([toCm(value, units), 0])} unit={unitMark(units)} />
      <MoveBy label="Up by" onMove={(value) => by([0, toCm(value, units)])} unit={unitMark(units)} />
      <Button
        className="small"
        onClick={deleteSelected}
        disabled={specification.pattern.panel_order.length === 0}
      >
        Delete
      </Button>
    </>
  );
}

function MoveBy({ label, unit, onMove }: { label: string; unit: string; onMove: (value: number) => void }) {
  const [round, setRound] = useState(0);
  return (
    <NumberField
      key={round}
      label={label}
      value={0}
      unit={unit}
      onChange={(value) => {
        onMove(value);
        setRound(round + 1);
      }}
    />
  );
}

const KINDS: { kind: CurveKind; label: string }[] = [
  { kind: "line", label: "Straight" },
  { kind: "quadratic", label: "Curve" },
  { kind: "cubic", label: "S-curve" },
  { kind: "circle", label: "Arc" },
];

function OneEdge({ specification, edge }: { specification: Specification; edge: EdgeRef }) {
  const units = useStudio((state) => state.units);
  const mirror = usePatternView((state) => state.mirror);
  const panel = panelOf(specification, edge.panel);
  const curve = curveOf(panel, edge.edge);
  const length = edgeLength(specification, edge);
  const number = stitchOf(specification, edge);
  const partner = number < 0 ? null : partnerIn(at(specification.pattern.stitches, number), edge);
  const other = partner === null ? null : edgeLength(specification, partner);
  const reshape = (label: string, shape: Shape) =>
    perform(label, (mirror ? reshapeMirrored : reshapeEdge)(specification, edge, shape));
  // Outward is to the right of an anticlockwise loop.
  const outward = signedArea(panel) >= 0 ? "right" : "left";
  const sign = outward === "right" ? -1 : 1;
  const setLength = (cm: number) =>
    performMoves(`Set length of edge of ${edge.panel}`, movesForLength(specification, edge, cm, "start"));
  return (
    <>
      <Title text={`Edge ${edge.edge}`} of={edge.panel} />
      <NumberField
        label="Length"
        value={fromCm(length, units)}
        unit={unitMark(units)}
        min={0.01}
        onChange={(value) => setLength(toCm(value, units))}
      />
      <NumberField
        label="Angle"
        value={angleOf(specification, edge)}
        unit="°"
        digits={1}
        step={1}
        onChange={(value) =>
          performMoves(`Turn edge of ${edge.panel}`, movesForAngle(specification, edge, value, "start"))
        }
      />
      <label className="number-field">
        <span>Shape</span>
        <select
          value={kindOf(curve.shape)}
          onChange={(event) => {
            const kind = event.target.value as CurveKind;
            reshape(kind === "line" ? "Straighten edge" : "Curve edge", shapeOfKind(curve, kind, outward));
          }}
        >
          {KINDS.map(({ kind, label }) => (
            <option key={kind} value={kind}>
              {label}
            </option>
          ))}
        </select>
      </label>
      <NumberField
        label="Depth"
        title="How far the middle stands off the straight line; outward is positive"
        value={fromCm(sign * depthOf(specification, edge), units)}
        unit={unitMark(units)}
        onChange={(value) => reshape("Bend edge", shapeOfDepth(curve, sign * toCm(value, units)))}
      />
      <Button className="small" title="Add a point to the middle (A)" onClick={() => addPointAt(edge, 0.5)}>
        Add point
      </Button>
      {partner !== null && other !== null ? (
        <>
          <span className="seam-note">
            Seam {number}: to edge {partner.edge} of {partner.panel}, {lengthText(other, units)}
          </span>
          {Math.abs(other - length) > SAME_CM && (
            <Button className="small" onClick={() => setLength(other)}>
              Make {lengthText(other, units)} long
            </Button>
          )}
          <Button className="small" title="Remove stitch (Delete)" onClick={() => removeStitches([number])}>
            Remove stitch
          </Button>
        </>
      ) : (
        <Button className="small" title="Sew to another edge (S)" onClick={sewSelected}>
          Sew to …
        </Button>
      )}
    </>
  );
}

function SeveralEdges({
  specification,
  edges,
  selection,
}: {
  specification: Specification;
  edges: readonly EdgeRef[];
  selection: readonly Target[];
}) {
  const units = useStudio((state) => state.units);
  const total = edges.reduce((sum, edge) => sum + edgeLength(specification, edge), 0);
  const [one, other] = edges;
  const stitches = selectedStitches(specification, selection);
  const free = edges.every((edge) => stitchOf(specification, edge) < 0);
  return (
    <>
      <Title text={`${edges.length} edges`} of={`${lengthText(total, units)} together`} />
      {one !== undefined && other !== undefined && edges.length === 2 && free && (
        <>
          <span className="seam-note">
            {lengthText(edgeLength(specification, one), units)} and{" "}
            {lengthText(edgeLength(specification, other), units)}
          </span>
          <Button
            className="small"
            look="primary"
            title="Sew together (S)"
            onClick={() => sewTogether(one, other)}
          >
            Sew together
          </Button>
        </>
      )}
      {stitches.length > 0 && (
        <Button className="small" onClick={() => removeStitches(stitches)}>
          {stitches.length === 1 ? "Remove stitch" : `Remove ${stitches.length} stitches`}
        </Button>
      )}
    </>
  );
}

function OneSeam({ specification, number }: { specification: Specification; number: number }) {
  const units = useStudio((state) => state.units);
  const stitch = at(specification.pattern.stitches, number);
  const [a, b] = [stitch[0], stitch[1]].map((side) => edgeLength(specification, side)) as [number, number];
  return (
    <>
      <Title text={`Seam ${number}`} of={`${stitch[0].panel} and ${stitch[1].panel}`} />
      <span className="seam-note">
        {lengthText(a, units)} and {lengthText(b, units)}
        {Math.abs(a - b) > SAME_CM && `: ${lengthText(Math.abs(a - b), units)} of difference`}
      </span>
      <Button className="small" onClick={() => removeStitches([number])}>
        Remove stitch
      </Button>
      <Button
        className="small"
        title="Sew the same edges the other way round"
        onClick={() => turnStitchOf(number)}
        aria-pressed={isRightWrong(stitch)}
      >
        Turn
      </Button>
    </>
  );
}

function OnePanel({ specification, name }: { specification: Specification; name: string }) {
  const units = useStudio((state) => state.units);
  const panel = panelOf(specification, name);
  const [width, height] = boxSize(panelBox(panel));
  const counterpart = counterpartOf(specification, name);
  const [text, setText] = useState(name);
  useEffect(() => setText(name), [name]);
  const rename = () => {
    if (text.trim() === name) setText(name);
    else if (!perform(`Rename ${name}`, renamePanel(specification, name, text))) setText(name);
  };
  const opposite =
    counterpart === null
      ? "no counterpart on the other side"
      : counterpart.panel === name
        ? "both halves are alike"
        : `mirrors ${counterpart.panel}`;
  return (
    <>
      <label className="number-field">
        <span>Panel</span>
        <input
          type="text"
          className="panel-name"
          value={text}
          onChange={(event) => setText(event.target.value)}
          onBlur={rename}
          onKeyDown={(event) => {
            if (event.key === "Enter") rename();
            if (event.key === "Escape") setText(name);
          }}
        />
      </label>
      <span className="seam-note">
        {lengthText(width, units)} × {lengthText(height, units)}, {panel.edges.length} edges; {opposite}
      </span>
      <Button
        className="small"
        title="Turn in the window (R); the garment stays as it is"
        onClick={() => rotateSelected(-90)}
      >
        Turn 90°
      </Button>
    </>
  );
}

function Title({ text, of }: { text: string; of: string }) {
  return (
    <h3>
      {text} <span className="muted">{of}</span>
    </h3>
  );
}
