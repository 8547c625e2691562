import { useEffect, useRef, useState } from "react";
import { BODY_ENDINGS, fitTo, fitToFile, fitToMesh } from "../actions/fit";
import { wearerKey, wearerOf } from "../actions/wearers";
import type { Figure, MeasureOption, WearerAnswer, WearerOptions } from "../api/types";
import { useSession } from "../state/session";
import { currentVersion, useStudio } from "../state/store";
import { fromCm, lengthText, toCm, type Units } from "../state/units";
import { Button } from "../ui/Button";
import { sentenceCase } from "../ui/sentence-case";

const DEFAULT_NAME = "the default body";

/** Who wears the garment: a size of a chart, measures, or a file of them. The pattern is refitted. */
export function BodyTab() {
  const pattern = useStudio((state) => currentVersion(state)?.pattern ?? null);
  const options = useSession((state) => state.server?.wearers ?? null);
  const busy = useSession((state) => state.working !== null || state.job !== null);
  const units = useStudio((state) => state.units);
  const wearer = useWearer();
  const file = useRef<HTMLInputElement>(null);
  const mesh = useRef<HTMLInputElement>(null);
  if (pattern === null) return <p className="empty-note">Make a garment or open one first.</p>;
  if (options === null || wearer === null) return <p className="empty-note">The body is being measured.</p>;
  const isKnown = ({ name }: MeasureOption) => name in wearer.given || name in wearer.measures;
  const isDefault = wearer.name === "" && Object.keys(wearer.given).length === 0 && wearer.figure === null;
  return (
    <>
      <section className="block first" aria-label="Worn by">
        <p className="worn-by" role="status">
          Made for <strong>{isDefault ? DEFAULT_NAME : wearer.name}</strong>
        </p>
        <p className="muted small-text">
          Choose a size, move a measure or load your own body: the pattern is refitted, and the garment sewn
          on that body. Ease, hems and style stay as they are.
        </p>
        {wearer.mesh != null && (
          <p className="small-text" data-stands-in={wearer.stands_in || undefined}>
            {wearer.stands_in
              ? "The mesh of this body is not kept here, and one of the same measures stands in for it. Load the file again to have it back."
              : "This is a mesh of your own. A size or a moved measure puts another body in its place."}
          </p>
        )}
        <input
          ref={mesh}
          type="file"
          id="body-input"
          hidden
          accept={BODY_ENDINGS.join(",")}
          onChange={(event) => {
            const [chosen] = event.target.files ?? [];
            event.target.value = "";
            if (chosen !== undefined) void fitToMesh(chosen);
          }}
        />
        <Button
          disabled={busy}
          title="A mesh (.obj, .ply, .glb, .stl) that stands upright along Y and faces +Z, arms away from the sides"
          onClick={() => mesh.current?.click()}
        >
          Load a body
        </Button>
        <button
          type="button"
          className="link start"
          disabled={busy || isDefault}
          onClick={() => void fitTo("For the default body", {})}
        >
          Back to the default body
        </button>
      </section>
      <Sizes options={options} wearer={wearer} busy={busy} />
      <section className="block" aria-label="Measures">
        <h2>
          Measures <span className="muted">{units === "cm" ? "in cm" : "in inches"}</span>
        </h2>
        <p className="muted small-text">
          Those marked with a dot are set; the likeliest body with them decides the others.
        </p>
        <div className="slider-group">
          {options.measures.filter(isKnown).map((option) => (
            <MeasureSlider key={option.name} {...{ option, wearer, units, busy }} />
          ))}
        </div>
        <input
          ref={file}
          type="file"
          hidden
          accept=".yaml,.yml,.json"
          onChange={(event) => {
            const [chosen] = event.target.files ?? [];
            event.target.value = "";
            if (chosen !== undefined) void fitToFile(chosen);
          }}
        />
        <Button
          disabled={busy}
          title="GarmentCode's or FreeSewing's measurements, as YAML or JSON"
          onClick={() => file.current?.click()}
        >
          Load measures
        </Button>
      </section>
    </>
  );
}

function Sizes({ options, wearer, busy }: { options: WearerOptions; wearer: WearerAnswer; busy: boolean }) {
  const [figure, setFigure] = useState<Figure>(wearer.figure ?? "women");
  const [region, setRegion] = useState("EU");
  const charts = options.sizes.filter((chart) => chart.figure === figure);
  const chart = charts.find((one) => one.region === region) ?? charts[0];
  if (chart === undefined) return null;
  return (
    <section className="block" aria-label="Size">
      <h2>Size</h2>
      <div className="field-row">
        <label className="field">
          <span className="label">Figure</span>
          <select value={figure} onChange={(event) => setFigure(event.target.value as Figure)}>
            {options.figures.map((each) => (
              <option key={each} value={each}>
                {sentenceCase(each)}
              </option>
            ))}
          </select>
        </label>
        <label className="field">
          <span className="label">Chart</span>
          <select value={chart.region} onChange={(event) => setRegion(event.target.value)}>
            {charts.map((each) => (
              <option key={each.region} value={each.region}>
                {each.region === "letters" ? "Letters" : each.region}
              </option>
            ))}
          </select>
        </label>
      </div>
      <fieldset className="sizes">
        <legend className="visually-hidden">
          {sentenceCase(figure)}, {chart.region}
        </legend>
        {chart.labels.map((label) => {
          const title = sizeTitle(figure, chart.region, label);
          return (
            <button
              key={label}
              type="button"
              aria-label={title}
              aria-pressed={wearer.name === title}
              disabled={busy}
              onClick={() => void fitTo(`For ${title}`, { size: title })}
            >
              {label}
            </button>
          );
        })}
      </fieldset>
    </section>
  );
}

function MeasureSlider(props: { option: MeasureOption; wearer: WearerAnswer; units: Units; busy: boolean }) {
  const { option, wearer, units, busy } = props;
  const [moved, setMoved] = useState<number | null>(null);
  const [of, setOf] = useState(wearer);
  if (of !== wearer) {
    setOf(wearer);
    setMoved(null);
  }
  const isSet = option.name in wearer.given;
  const measured = wearer.given[option.name] ?? wearer.measures[option.name] ?? option.default;
  const value = moved ?? measured;
  const label = sentenceCase(option.label);
  const end = async () => {
    if (moved === null || Math.abs(moved - measured) < 0.05) return setMoved(null);
    const to = Math.min(option.max, Math.max(option.min, moved));
    const measures = { ...wearer.given, [option.name]: Number(to.toFixed(1)) };
    const done = await fitTo(`${label}: ${lengthText(to, units)}`, {
      measures,
      ...(wearer.figure !== null ? { figure: wearer.figure } : {}),
      ...(wearer.name !== "" ? { called: calledSo(wearer.name, option.label, to) } : {}),
    });
    if (!done) setMoved(null);
  };
  return (
    <div className="slider" data-set={isSet ? true : undefined}>
      <label>
        <span className="slider-name" title={option.about}>
          {label}
        </span>
        <input
          type="range"
          min={option.min}
          max={option.max}
          step={0.5}
          title={option.about}
          disabled={busy}
          value={value}
          aria-valuetext={`${lengthText(value, units)}${isSet ? ", set" : ""}`}
          style={
            {
              "--share": `${(100 * (value - option.min)) / (option.max - option.min)}%`,
            } as React.CSSProperties
          }
          onChange={(event) => setMoved(Number(event.target.value))}
          onPointerUp={() => void end()}
          onKeyUp={(event) => {
            if (event.key === "Enter") void end();
          }}
          onBlur={() => void end()}
        />
      </label>
      <input
        type="number"
        className="slider-number"
        aria-label={`${label}, ${units === "cm" ? "cm" : "inches"}`}
        disabled={busy}
        value={Number(fromCm(value, units).toFixed(1))}
        min={fromCm(option.min, units)}
        max={fromCm(option.max, units)}
        step="any"
        onChange={(event) => {
          if (event.target.value !== "") setMoved(toCm(Number(event.target.value), units));
        }}
        onBlur={() => void end()}
        onKeyDown={(event) => {
          if (event.key === "Enter") void end();
        }}
      />
    </div>
  );
}

/** "women EU 44, height 178" with another measure in it. */
function calledSo(name: string, label: string, cm: number): string {
  const kept = name.split(", ").filter((part) => !part.startsWith(`${label} `));
  return [...kept, `${label} ${Number(cm.toFixed(1))}`].join(", ");
}

function sizeTitle(figure: Figure, region: string, label: string): string {
  return region === "letters" ? `${figure} ${label}` : `${figure} ${region} ${label}`;
}

/** Who wears the shown pattern; null while that is being found out. */
function useWearer(): WearerAnswer | null {
  const pattern = useStudio((state) => currentVersion(state)?.pattern ?? null);
  const server = useSession((state) => state.server !== null);
  const [wearer, setWearer] = useState<WearerAnswer | null>(null);
  const key = wearerKey(pattern);
  // biome-ignore lint/correctness/useExhaustiveDependencies: the key stands for the pattern's wearer.
  useEffect(() => {
    let current = true;
    if (server)
      wearerOf(pattern).then(
        (found) => current && setWearer(found),
        () => {},
      );
    return () => {
      current = false;
    };
  }, [key, server]);
  return wearer;
}
