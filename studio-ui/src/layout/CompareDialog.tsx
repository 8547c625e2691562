import { useEffect, useRef, useState } from "react";
import { bodyOf } from "../actions/wearers";
import { garmentMesh } from "../garment/mesh-cache";
import { ownLook } from "../garment/own-look";
import { GarmentViewer } from "../garment/viewer";
import type { Version } from "../state/document";
import type { HistoryEntry } from "../state/history";
import { useSession } from "../state/session";
import { useStudio } from "../state/store";
import { lengthText, trimmed, type Units } from "../state/units";
import { Button } from "../ui/Button";
import { Dialog } from "../ui/Dialog";
import { PatternThumbnail } from "../ui/PatternThumbnail";
import { sentenceCase } from "../ui/sentence-case";
import { type CameraLink, cameraLink } from "./camera-link";

/** Two versions side by side, turned together, with what differs between them. */
export function CompareDialog() {
  const history = useStudio((state) => state.history);
  const units = useStudio((state) => state.units);
  const { set } = useSession.getState();
  const last = history?.index ?? 0;
  const [left, setLeft] = useState(Math.max(0, last - 1));
  const [right, setRight] = useState(last === 0 ? 1 : last);
  const [link] = useState(cameraLink);
  if (history === null) return null;
  const a = history.entries[left];
  const b = history.entries[right];
  if (a === undefined || b === undefined) return null;
  const close = () => set({ dialog: null });
  return (
    <Dialog title="Compare two versions" onClose={close} size="full">
      <div className="compare">
        {[
          { entry: a, at: left, choose: setLeft, name: "Left" },
          { entry: b, at: right, choose: setRight, name: "Right" },
        ].map(({ entry, at, choose, name }) => (
          <section key={name} aria-label={`${name}: ${entry.label}`}>
            <div className="row">
              <label className="inline grow">
                <span className="visually-hidden">{name} version</span>
                <select value={at} onChange={(event) => choose(Number(event.target.value))}>
                  {history.entries.map((each, k) => (
                    <option key={each.id} value={k}>
                      {k + 1}. {each.label}
                    </option>
                  ))}
                </select>
              </label>
              <Button
                className="small"
                onClick={() => {
                  useStudio.getState().goTo(at);
                  close();
                }}
              >
                Go to this one
              </Button>
            </div>
            <div className="compare-views">
              <GarmentView entry={entry} link={link} />
              <PatternThumbnail pattern={entry.value.pattern} label={`Pattern of ${entry.label}`} />
            </div>
          </section>
        ))}
        <Differences a={a.value} b={b.value} units={units} />
      </div>
    </Dialog>
  );
}

function GarmentView({ entry, link }: { entry: HistoryEntry<Version>; link: CameraLink }) {
  const box = useRef<HTMLDivElement>(null);
  const [viewer, setViewer] = useState<GarmentViewer | null>(null);
  const { mesh, pattern, color, looks, print } = entry.value;
  useEffect(() => {
    if (box.current === null) return;
    const made = new GarmentViewer(box.current);
    setViewer(made);
    const unlink = link.add(made);
    return () => {
      unlink();
      made.dispose();
    };
  }, [link]);
  useEffect(() => {
    if (viewer === null) return;
    let gone = false;
    void ownLook({ color, ...(looks !== undefined ? { looks } : {}), print: print ?? null }).then((look) => {
      if (!gone) viewer.setLook(look);
    });
    viewer.setSeamsVisible(false);
    viewer.showBody(null);
    void bodyOf(pattern).then((data) => {
      if (!gone) viewer.showBody(data);
    });
    if (mesh === null) viewer.showGarment(null, []);
    else
      garmentMesh(mesh).then(
        (data) => {
          if (gone) return;
          const first = viewer.data === null;
          viewer.showGarment(data, []);
          if (first) link.frame(viewer);
        },
        () => {
          if (!gone) viewer.showGarment(null, []);
        },
      );
    return () => {
      gone = true;
    };
  }, [viewer, mesh, pattern, color, looks, print, link]);
  return (
    <div className="compare-stage">
      <div
        ref={box}
        className="canvas"
        role="img"
        aria-label={`Garment of ${entry.label}. Drag to turn both.`}
      />
      {mesh === null && <p className="stage-note">This version has not been sewn. Go to it, and it is.</p>}
    </div>
  );
}

function Differences({ a, b, units }: { a: Version; b: Version; units: Units }) {
  const rows = dimensionRows(a, b, units);
  const words = b.changes.length > 0 ? b.changes : [];
  return (
    <section className="differences" aria-label="Differences">
      <h3>What differs</h3>
      {words.length > 0 && (
        <ul>
          {words.map((word) => (
            <li key={word}>{word}</li>
          ))}
        </ul>
      )}
      {rows.length > 0 ? (
        <table>
          <thead>
            <tr>
              <th scope="col">Dimension</th>
              <th scope="col">Left</th>
              <th scope="col">Right</th>
              <th scope="col">Difference</th>
            </tr>
          </thead>
          <tbody>
            {rows.map(([name, left, right, difference]) => (
              <tr key={name}>
                <th scope="row" className="sentence">
                  {name}
                </th>
                <td>{left}</td>
                <td>{right}</td>
                <td>{difference}</td>
              </tr>
            ))}
          </tbody>
        </table>
      ) : (
        <p className="muted">
          {a.dimensions === null || b.dimensions === null
            ? "A version that was not looked at yet has no dimensions: go to it once."
            : "No dimension differs by more than a millimetre."}
        </p>
      )}
    </section>
  );
}

function dimensionRows(a: Version, b: Version, units: Units): [string, string, string, string][] {
  const written = (value: number, unit: string) =>
    unit === "cm" ? lengthText(value, units) : trimmed(value, 2);
  return (b.dimensions ?? []).flatMap((after) => {
    const before = (a.dimensions ?? []).find((each) => each.name === after.name);
    if (before === undefined) return [];
    const by = after.value - before.value;
    if (Math.abs(by) < (after.unit === "cm" ? 0.1 : 0.01)) return [];
    const sign = by > 0 ? "+" : "";
    return [
      [
        sentenceCase(after.name),
        written(before.value, after.unit),
        written(after.value, after.unit),
        sign + written(by, after.unit),
      ] as [string, string, string, string],
    ];
  });
}
