import type { Target } from "../../state/selection";
import { currentVersion, shownFindings, useStudio } from "../../state/store";
import { lengthText } from "../../state/units";
import { bendHandlesOf } from "../edits/bend-handles";
import { mirroredEdge, mirroredVertex } from "../edits/mirror";
import { at } from "../geometry/at";
import { pointAt } from "../geometry/curve";
import { curveOf } from "../geometry/outline";
import { edgePath, outlinePath } from "../geometry/path";
import { type Arrangement, toPanel, toSheet } from "../layout/arrangement";
import { type EdgeRef, type Point, panelOf, partnerIn, type Specification, stitchOf } from "../specification";
import { placeTransform, Text } from "./PanelShape";
import { usePatternView } from "./pattern-view-state";

interface OverlayProps {
  specification: Specification;
  arrangement: Arrangement;
}

/** What is selected and pointed at, with points and handles to take hold of. */
export function Overlay({ specification, arrangement }: OverlayProps) {
  const selection = useStudio((state) => state.selection).filter((t) => isThere(t, specification));
  const hover = useStudio((state) => state.hover);
  const mirror = usePatternView((state) => state.mirror);
  const shown = hover !== null && isThere(hover, specification) ? hover : null;
  const active = activePanels(specification, selection);
  // What mirrors what does not change while something is dragged, and takes a while to find.
  const version: Specification = useStudio((state) => currentVersion(state)?.pattern) ?? specification;
  const opposite = mirror ? mirroredTargets(version, selection).filter((t) => isThere(t, specification)) : [];
  return (
    <g className="overlay">
      {shown !== null && <Highlight {...{ specification, arrangement }} target={shown} look="hover" />}
      {opposite.map((target) => (
        <Highlight key={keyOf(target)} {...{ specification, arrangement, target }} look="mirrored" />
      ))}
      {selection.map((target) => (
        <Highlight key={keyOf(target)} {...{ specification, arrangement, target }} look="selected" />
      ))}
      {active.map((name) => (
        <ActivePanel key={name} {...{ specification, arrangement, name, selection }} />
      ))}
      <BendHandles {...{ specification, arrangement, selection }} />
      <FindingMarks arrangement={arrangement} />
      <Ghost {...{ specification, arrangement }} />
      <Guides arrangement={arrangement} />
      <Marquee />
    </g>
  );
}

function isThere(target: Target, { pattern }: Specification): boolean {
  if (target.kind === "seam") return target.stitch < pattern.stitches.length;
  const panel = pattern.panels[target.panel];
  if (panel === undefined) return false;
  if (target.kind === "edge") return target.edge < panel.edges.length;
  return target.kind === "panel" || target.vertex < panel.vertices.length;
}

export function keyOf(target: Target): string {
  return JSON.stringify(target);
}

function activePanels(specification: Specification, selection: readonly Target[]): string[] {
  const names = selection.flatMap((target) => {
    if (target.kind !== "seam") return [target.panel];
    const stitch = at(specification.pattern.stitches, target.stitch);
    return [stitch[0].panel, stitch[1].panel];
  });
  return [...new Set(names)].slice(0, 6);
}

function mirroredTargets(specification: Specification, selection: readonly Target[]): Target[] {
  return selection.flatMap((target): Target[] => {
    if (!isThere(target, specification)) return [];
    if (target.kind === "edge") {
      const edge = mirroredEdge(specification, target);
      return edge === null ? [] : [{ kind: "edge", ...edge }];
    }
    if (target.kind === "vertex") {
      const vertex = mirroredVertex(specification, target);
      return vertex === null ? [] : [{ kind: "vertex", ...vertex }];
    }
    return [];
  });
}

interface HighlightProps extends OverlayProps {
  target: Target;
  look: "hover" | "selected" | "mirrored";
}

function Highlight({ specification, arrangement, target, look }: HighlightProps) {
  if (target.kind === "seam") {
    const stitch = at(specification.pattern.stitches, target.stitch);
    return (
      <>
        {[stitch[0], stitch[1]].map((side) => (
          <Highlight
            key={`${side.panel} ${side.edge}`}
            {...{ specification, arrangement, look }}
            target={{ kind: "edge", ...side }}
          />
        ))}
      </>
    );
  }
  const place = arrangement[target.panel];
  if (place === undefined) return null;
  const panel = panelOf(specification, target.panel);
  return (
    <>
      <g transform={placeTransform(place)} className={`highlight ${look}`}>
        {target.kind === "panel" && <path d={outlinePath(panel)} />}
        {target.kind === "edge" && <path d={edgePath(panel, target.edge)} />}
        {target.kind === "vertex" && <Dot point={at(panel.vertices, target.vertex)} className="ring" />}
      </g>
      {target.kind === "edge" && look !== "mirrored" && (
        <Partner {...{ specification, arrangement }} edge={target} look={look} />
      )}
    </>
  );
}

/** The edge that one is sewn to, and a line to it. */
function Partner({
  specification,
  arrangement,
  edge,
  look,
}: OverlayProps & { edge: EdgeRef; look: "hover" | "selected" }) {
  const number = stitchOf(specification, edge);
  if (number < 0) return null;
  const other = partnerIn(at(specification.pattern.stitches, number), edge);
  const place = arrangement[other.panel];
  const [from, to] = [edge, other].map((ref) => middleOnSheet(specification, arrangement, ref));
  if (place === undefined || !from || !to) return null;
  return (
    <g className={`partner ${look}`}>
      <path transform={placeTransform(place)} d={edgePath(panelOf(specification, other.panel), other.edge)} />
      <path className="thread" d={`M${from}L${to}`} />
    </g>
  );
}

function middleOnSheet(specification: Specification, arrangement: Arrangement, ref: EdgeRef): Point | null {
  const place = arrangement[ref.panel];
  return place === undefined
    ? null
    : toSheet(place, pointAt(curveOf(panelOf(specification, ref.panel), ref.edge), 0.5));
}

/** Points and edges of a panel in which something is selected: these can be reached with Tab. */
function ActivePanel({
  specification,
  arrangement,
  name,
  selection,
}: OverlayProps & { name: string; selection: readonly Target[] }) {
  const place = arrangement[name];
  const units = useStudio((state) => state.units);
  const select = useStudio((state) => state.select);
  const panel = panelOf(specification, name);
  if (place === undefined) return null;
  const isSelected = (target: Target) => selection.some((t) => keyOf(t) === keyOf(target));
  const focusable = (target: Target, label: string) => ({
    role: "button",
    tabIndex: 0,
    "aria-label": label,
    "aria-pressed": isSelected(target),
    "data-target": keyOf(target),
    onFocus: (event: React.FocusEvent<SVGElement>) => {
      if (event.currentTarget.matches(":focus-visible") && !isSelected(target)) select(target);
    },
    onKeyDown: (event: React.KeyboardEvent) => {
      if (event.key !== "Enter" && event.key !== " ") return;
      event.preventDefault();
      select(target, event.shiftKey ? "toggle" : "replace");
    },
  });
  return (
    <g transform={placeTransform(place)} className="active">
      {panel.vertices.map((point, k) => {
        const [x, y] = point.map((value) => lengthText(value, units));
        const number = stitchOf(specification, { panel: name, edge: k });
        const other =
          number < 0 ? null : partnerIn(at(specification.pattern.stitches, number), { panel: name, edge: k });
        const sewn = other === null ? "free" : `sewn to edge ${other.edge} of ${other.panel}, seam ${number}`;
        return (
          // biome-ignore lint/suspicious/noArrayIndexKey: a point is its number.
          <g key={k}>
            <path
              className="edge-handle"
              d={edgePath(panel, k)}
              {...focusable({ kind: "edge", panel: name, edge: k }, `Edge ${k} of ${name}, ${sewn}`)}
            />
            <Dot
              point={point}
              className={
                isSelected({ kind: "vertex", panel: name, vertex: k }) ? "vertex selected" : "vertex"
              }
              {...focusable(
                { kind: "vertex", panel: name, vertex: k },
                `Point ${k} of ${name}, at ${x}, ${y}`,
              )}
            />
          </g>
        );
      })}
    </g>
  );
}

function BendHandles({
  specification,
  arrangement,
  selection,
}: OverlayProps & { selection: readonly Target[] }) {
  return selection.map((target) => {
    if (target.kind !== "edge") return null;
    const place = arrangement[target.panel];
    if (place === undefined) return null;
    const curve = curveOf(panelOf(specification, target.panel), target.edge);
    const handles = bendHandlesOf(curve);
    const bezier = curve.shape !== undefined && curve.shape.type !== "circle";
    const ends = handles.length === 1 ? [curve.start, curve.end] : [curve.start];
    return (
      <g key={keyOf(target)} transform={placeTransform(place)} className="bend">
        {bezier &&
          handles.length === 1 &&
          ends.map((end) => <path key={`${end}`} d={`M${end}L${handles[0]}`} />)}
        {bezier && handles.length === 2 && (
          <path d={`M${curve.start}L${handles[0]}M${curve.end}L${handles[1]}`} />
        )}
        {handles.map((point, k) => (
          // biome-ignore lint/suspicious/noArrayIndexKey: a handle is its number.
          <Dot key={k} point={point} className="handle" data-handle={k} />
        ))}
      </g>
    );
  });
}

/** Rings around the places of faults. */
function FindingMarks({ arrangement }: { arrangement: Arrangement }) {
  const findings = useStudio(shownFindings) ?? [];
  return findings.map((finding) => {
    const place = arrangement[finding.panel];
    if (place === undefined || finding.severity === "info") return null;
    return (finding.points ?? []).map((point) => (
      <g key={`${finding.code} ${point}`} transform={placeTransform(place)}>
        <Dot point={point} className={`fault ${finding.severity}`} />
      </g>
    ));
  });
}

/** Where a click would add a point. */
function Ghost({ specification, arrangement }: OverlayProps) {
  const ghost = usePatternView((state) => state.ghost);
  const place = ghost && arrangement[ghost.panel];
  if (!ghost || !place || !isThere({ kind: "edge", ...ghost }, specification)) return null;
  return (
    <g transform={placeTransform(place)}>
      <Dot
        point={pointAt(curveOf(panelOf(specification, ghost.panel), ghost.edge), ghost.t)}
        className="ghost"
      />
    </g>
  );
}

function Guides({ arrangement }: { arrangement: Arrangement }) {
  const guides = usePatternView((state) => state.guides);
  return guides.map((guide) => {
    const place = arrangement[guide.panel];
    if (place === undefined) return null;
    const [from, to] = [toSheet(place, guide.from), toSheet(place, guide.to)];
    const upright = { ...place, angle: 0, mirrored: false, at: [0, 0] as Point };
    return (
      <g key={`${guide.label} ${guide.from}`} className="guide">
        <path d={`M${from}L${to}`} />
        <Text place={upright} point={toPanel(upright, from)} className="guide-label" size={11}>
          {guide.label}
        </Text>
      </g>
    );
  });
}

function Marquee() {
  const marquee = usePatternView((state) => state.marquee);
  if (marquee === null) return null;
  const { from, to } = marquee;
  return <path className="marquee" d={`M${from}H${to[0]}V${to[1]}H${from[0]}Z`} />;
}

/** A dot of constant size on the screen; its radius is in the style sheet. */
function Dot({
  point,
  className,
  ...rest
}: { point: Point; className: string } & React.SVGProps<SVGCircleElement>) {
  return <circle cx={point[0]} cy={point[1]} className={`dot ${className}`} {...rest} />;
}
