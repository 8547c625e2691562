import { useState } from "react";
import { alter } from "../actions/alter";
import type { Chip } from "../api/types";
import { useStudio } from "../state/store";
import { fromCm, lengthText, toCm, trimmed, type Units, unitMark } from "../state/units";
import { Button } from "../ui/Button";
import { Icon } from "../ui/Icon";
import { Popover } from "../ui/Popover";
import type { ChipKind } from "./ChipList";

/** One statement that was read: pressed, it offers what else it could be, and the pattern is cut to it. */
export function ReadingChip({ chip, kind }: { chip: Chip; kind: ChipKind }) {
  const units = useStudio((state) => state.units);
  const text = chipText(chip, units);
  const broken = chip.holds === false && kind !== "cannot" && kind !== "unknown";
  const state = broken ? "broken" : kind;
  const fixed =
    (chip.claim === null && chip.dimension === null) || (chip.choices.length === 0 && chip.range === null);
  const about = [
    chip.about,
    chip.certainty !== null ? `${Math.round(100 * chip.certainty)} % sure, from the ${chip.from}` : "",
    broken ? "The pattern does not show it" : "",
  ]
    .filter((part) => part !== "")
    .join(". ");
  if (fixed)
    return (
      <span className={`chip ${state}`} title={about}>
        <Mark state={state} />
        {text}
      </span>
    );
  return (
    <Popover
      label={`Change ${chip.label}`}
      trigger={({ ref, ...attributes }) => (
        <button ref={ref} type="button" className={`chip ${state}`} title={about} {...attributes}>
          <Mark state={state} />
          {text}
          <Icon name="chevron" size={12} />
        </button>
      )}
    >
      {(close) => (
        <div className="chip-popover">
          <p className="about">{chip.about}</p>
          {chip.choices.length > 0 ? (
            <Choices chip={chip} close={close} />
          ) : (
            <NumberField chip={chip} units={units} close={close} />
          )}
        </div>
      )}
    </Popover>
  );
}

function Mark({ state }: { state: string }) {
  const icon = {
    made: "check",
    assumed: "info",
    cannot: "close",
    unknown: "help",
    broken: "warning",
  } as const;
  return state in icon ? <Icon name={icon[state as keyof typeof icon]} size={13} /> : null;
}

function Choices({ chip, close }: { chip: Chip; close: () => void }) {
  return (
    <div className="choices" role="listbox" aria-label={chip.label}>
      {chip.choices.map((choice) => (
        <button
          key={choice}
          type="button"
          role="option"
          aria-selected={choice === chip.value}
          data-autofocus={choice === chip.value || undefined}
          onClick={() => {
            close();
            if (choice !== chip.value || chip.holds === false)
              void alter(`${chip.label}: ${choice}`, { claim: chip.claim, value: choice });
          }}
        >
          {choice}
          {choice === chip.value && <Icon name="check" size={14} />}
        </button>
      ))}
    </div>
  );
}

function NumberField({ chip, units, close }: { chip: Chip; units: Units; close: () => void }) {
  const inUnits = chip.unit === "cm";
  const start = typeof chip.value === "number" ? chip.value : (chip.range?.min ?? 0);
  const [value, setValue] = useState(inUnits ? round(fromCm(start, units)) : start);
  const shown = (number: number) => (inUnits ? round(fromCm(number, units)) : number);
  return (
    <form
      className="number-form"
      onSubmit={(event) => {
        event.preventDefault();
        close();
        const cm = inUnits ? toCm(value, units) : value;
        const change =
          chip.claim !== null ? { claim: chip.claim, value: cm } : { dimension: chip.dimension, value: cm };
        void alter(`${chip.label}: ${inUnits ? lengthText(cm, units) : trimmed(cm, 2)}`, change);
      }}
    >
      <label>
        <span className="visually-hidden">{chip.label}</span>
        <input
          type="number"
          value={value}
          data-autofocus
          {...(chip.range ? { min: shown(chip.range.min), max: shown(chip.range.max) } : {})}
          step="any"
          onChange={(event) => setValue(Number(event.target.value))}
        />
      </label>
      <span>{inUnits ? unitMark(units) : chip.unit}</span>
      <Button look="primary" className="small" onClick={(event) => event.currentTarget.form?.requestSubmit()}>
        Set
      </Button>
    </form>
  );
}

const round = (value: number) => Math.round(10 * value) / 10;

function chipText(chip: Chip, units: Units): string {
  if (chip.unit === "cm" && typeof chip.value === "number" && units === "inch")
    return `${chip.label}: ${lengthText(chip.value, units)}`;
  return chip.text;
}
