import { useState } from "react";
import { slideEnds, slideTo } from "../actions/alter";
import type { DimensionInfo } from "../api/types";
import { currentVersion, useStudio } from "../state/store";
import { fromCm, lengthText, toCm, trimmed, type Units } from "../state/units";
import { sentenceCase } from "../ui/sentence-case";

const GROUPS: [string, string][] = [
  ["length", "Length"],
  ["width", "Width"],
  ["neck", "Neckline"],
  ["sleeves", "Sleeves"],
  ["details", "Details"],
];

/** The levers that words pull, as sliders: the garment follows while they move. */
export function DimensionSliders() {
  const dimensions = useStudio((state) => currentVersion(state)?.dimensions ?? null);
  const [last, setLast] = useState<DimensionInfo[]>([]);
  // While a changed pattern is measured, the sliders stay where they are.
  if (dimensions !== null && dimensions !== last) setLast(dimensions);
  const shown = dimensions ?? last;
  const units = useStudio((state) => state.units);
  if (shown.length === 0) return null;
  return (
    <section className="block" aria-label="Dimensions" data-tour="sliders">
      <h2>
        Dimensions <span className="muted">{units === "cm" ? "in cm" : "in inches"}</span>
      </h2>
      {GROUPS.map(([group, title]) => {
        const own = shown.filter((dimension) => dimension.group === group);
        if (own.length === 0) return null;
        return (
          <fieldset key={group} className="slider-group">
            <legend>{title}</legend>
            {own.map((dimension) => (
              <DimensionSlider key={dimension.name} dimension={dimension} units={units} />
            ))}
          </fieldset>
        );
      })}
    </section>
  );
}

function DimensionSlider({ dimension, units }: { dimension: DimensionInfo; units: Units }) {
  const [moved, setMoved] = useState<number | null>(null);
  const [of, setOf] = useState(dimension);
  if (of !== dimension) {
    setOf(dimension);
    setMoved(null);
  }
  const value = moved ?? dimension.value;
  const name = sentenceCase(dimension.name);
  const about = sentenceCase(dimension.about);
  const label = (at: number) => `${name}: ${valueText(at, dimension, units)}`;
  const inUnits = dimension.unit === "cm";
  const typed = inUnits ? fromCm(value, units) : value;
  const change = (to: number) => {
    const inside = Math.min(dimension.max, Math.max(dimension.min, to));
    setMoved(inside);
    slideTo(dimension.name, inside, label(inside));
    return inside;
  };
  const end = () => {
    if (moved !== null) slideEnds(label(moved));
  };
  return (
    <div className="slider">
      <label>
        <span className="slider-name" title={about}>
          {name}
        </span>
        <input
          type="range"
          min={dimension.min}
          max={dimension.max}
          step={dimension.step}
          title={about}
          value={value}
          aria-valuetext={valueText(value, dimension, units)}
          style={
            {
              "--share": `${(100 * (value - dimension.min)) / (dimension.max - dimension.min || 1)}%`,
            } as React.CSSProperties
          }
          onChange={(event) => change(Number(event.target.value))}
          onPointerUp={end}
          onKeyUp={end}
          onBlur={end}
        />
      </label>
      <input
        type="number"
        className="slider-number"
        aria-label={`${name}, ${inUnits ? (units === "cm" ? "cm" : "inches") : dimension.unit}`}
        value={Number(typed.toFixed(inUnits ? 1 : 2))}
        min={inUnits ? fromCm(dimension.min, units) : dimension.min}
        max={inUnits ? fromCm(dimension.max, units) : dimension.max}
        step="any"
        onChange={(event) => {
          const number = Number(event.target.value);
          if (event.target.value !== "") change(inUnits ? toCm(number, units) : number);
        }}
        onBlur={end}
        onKeyDown={(event) => {
          if (event.key === "Enter") end();
        }}
      />
    </div>
  );
}

function valueText(value: number, dimension: DimensionInfo, units: Units): string {
  if (dimension.unit === "cm") return lengthText(value, units);
  return dimension.unit === "times" ? `${trimmed(value, 2)} times` : trimmed(value, 0);
}
