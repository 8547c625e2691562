import { useRef } from "react";
import { useDisplay } from "../state/display";
import { useSession } from "../state/session";
import { currentVersion, useStudio } from "../state/store";
import { lengthText } from "../state/units";
import { Icon } from "../ui/Icon";
import { DrapeBar } from "./DrapeBar";
import { GarmentToolbar, ViewTools } from "./GarmentToolbar";
import { STRAIN_STOPS, strainGradient } from "./strain-colors";
import { useGarmentViewer } from "./useGarmentViewer";
import type { GarmentViewer } from "./viewer";

const ORBIT = Math.PI / 18;

export function GarmentWindow() {
  const box = useRef<HTMLDivElement>(null);
  const viewer = useGarmentViewer(box);
  return (
    <section className="window garment-window" aria-label="Garment" data-tour="garment">
      <GarmentToolbar viewer={viewer} />
      <div className="stage">
        {/* biome-ignore-start lint/a11y/noNoninteractiveTabindex: a view that is turned by keys. */}
        <div
          ref={box}
          className="canvas"
          role="application"
          tabIndex={0}
          aria-label="Garment in 3D. Arrow keys orbit, plus and minus zoom, 1 to 4 look from a side."
          onKeyDown={(event) => {
            if (viewer !== null && handleKey(viewer, event)) {
              event.preventDefault();
              event.stopPropagation();
            }
          }}
          onPointerMove={(event) => {
            if (viewer === null || event.buttons !== 0) return;
            useStudio.getState().setHover(pickAt(viewer, event));
          }}
          onPointerLeave={() => useStudio.getState().setHover(null)}
          onPointerDown={(event) => {
            event.currentTarget.dataset.pressed = `${event.clientX} ${event.clientY}`;
          }}
          onPointerUp={(event) => {
            const [x, y] = (event.currentTarget.dataset.pressed ?? "").split(" ").map(Number) as [
              number,
              number,
            ];
            // A press that moved was an orbit.
            if (viewer === null || Math.hypot(event.clientX - x, event.clientY - y) > 4 || event.button !== 0)
              return;
            useStudio.getState().select(pickAt(viewer, event), event.shiftKey ? "toggle" : "replace");
          }}
          onDoubleClick={() => viewer?.frameAll(true)}
        />
        {/* biome-ignore-end lint/a11y/noNoninteractiveTabindex: a view that is turned by keys. */}
        <ViewTools viewer={viewer} />
        <State />
        <StrainLegend />
      </div>
      <DrapeBar />
    </section>
  );
}

function pickAt(viewer: GarmentViewer, event: React.PointerEvent<HTMLElement>) {
  const bounds = event.currentTarget.getBoundingClientRect();
  return viewer.pick(event.clientX - bounds.left, event.clientY - bounds.top);
}

function handleKey(viewer: GarmentViewer, event: React.KeyboardEvent): boolean {
  if (event.ctrlKey || event.metaKey || event.altKey) return false;
  const { stage } = viewer;
  const display = useDisplay.getState();
  const colorings = ["cloth", "panels", "strain"] as const;
  const moves = new Map<string, () => void>([
    ["ArrowLeft", () => (event.shiftKey ? stage.pan(-0.04, 0) : stage.orbit(-ORBIT, 0))],
    ["ArrowRight", () => (event.shiftKey ? stage.pan(0.04, 0) : stage.orbit(ORBIT, 0))],
    ["ArrowUp", () => (event.shiftKey ? stage.pan(0, 0.04) : stage.orbit(0, -ORBIT))],
    ["ArrowDown", () => (event.shiftKey ? stage.pan(0, -0.04) : stage.orbit(0, ORBIT))],
    ["+", () => stage.orbit(0, 0, 1.15)],
    ["=", () => stage.orbit(0, 0, 1.15)],
    ["-", () => stage.orbit(0, 0, 1 / 1.15)],
    ["1", () => viewer.look("front")],
    ["2", () => viewer.look("back")],
    ["3", () => viewer.look("left")],
    ["4", () => viewer.look("right")],
    ["0", () => viewer.frameAll(true)],
    ["Home", () => viewer.frameAll(true)],
    ["b", () => display.change({ body: !display.body })],
    ["w", () => display.change({ wireframe: !display.wireframe })],
    ["n", () => display.change({ normals: !display.normals })],
    ["s", () => display.change({ seams: !display.seams })],
    [
      "x",
      () =>
        display.change({
          coloring: colorings[(colorings.indexOf(display.coloring) + 1) % 3] ?? "cloth",
          normals: false,
        }),
    ],
  ]);
  const move = moves.get(event.key);
  move?.();
  return move !== undefined;
}

/** What the view shows, where that is not the pattern as it is drawn. */
function State() {
  const unsewable = useSession((state) => state.unsewable);
  const sewing = useSession((state) => state.sewing);
  const lastSewn = useSession((state) => state.lastSewn);
  const version = useStudio(currentVersion);
  const draft = useStudio((state) => state.draft);
  const job = useSession((state) => state.job);
  const shown = useStudio(
    (state) => state.history?.entries.some(({ value }) => value.mesh !== null) ?? false,
  );
  if (version === null) return null;
  if (job?.kind === "drape" || job?.kind === "finish")
    return (
      <div className="stage-note" role="status" data-state="moving">
        <span className="pulse on" aria-hidden="true" />
        {job.kind === "drape" ? "Draping …" : "Finishing …"}
      </div>
    );
  if (unsewable !== null)
    return (
      <div className="stage-note warning" role="status">
        <Icon name="warning" />
        <div>
          <p>{unsewable.message}</p>
          {unsewable.hint !== "" && <p className="hint">{unsewable.hint}</p>}
          {shown && <p className="hint">The garment shown is the last that could be sewn.</p>}
        </div>
      </div>
    );
  const how = {
    none: "Not sewn yet",
    sewn: lastSewn !== null ? `Sewn in ${lastSewn.toFixed(2)} s` : "Sewn",
    finished: "Finished by physics",
    draped: "Draped by physics",
    stopped: "Draped until stopped",
  }[draft !== null ? "sewn" : version.garment];
  return (
    <div className="stage-note" role="status" data-state={sewing ? "sewing" : version.garment}>
      <span className={`pulse ${sewing ? "on" : ""}`} aria-hidden="true" />
      {sewing ? "Sewing …" : how}
    </div>
  );
}

function StrainLegend() {
  const strain = useDisplay((state) => state.coloring === "strain" && !state.normals);
  const units = useStudio((state) => state.units);
  if (!strain) return null;
  const low = STRAIN_STOPS[0]?.[0] ?? 0;
  const high = STRAIN_STOPS.at(-1)?.[0] ?? 1;
  return (
    <figure className="legend">
      <figcaption>How much the cloth is stretched</figcaption>
      <div className="legend-bar" style={{ background: strainGradient() }} />
      <div className="legend-marks" aria-hidden="true">
        {[0, 0.05, 0.12, 0.25].map((mark) => (
          <span key={mark} style={{ left: `${(100 * (mark - low)) / (high - low)}%` }}>
            {Math.round(100 * mark)} %
          </span>
        ))}
      </div>
      <p className="hint">
        At 12 % a width of {lengthText(50, units)} is pulled by {lengthText(6, units)}: too tight.
      </p>
    </figure>
  );
}
