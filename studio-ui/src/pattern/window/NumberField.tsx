import { useEffect, useState } from "react";
import { trimmed } from "../../state/units";

interface NumberFieldProps {
  label: string;
  /** What it means, as a tooltip. */
  title?: string;
  /** null: there is no number, as of several edges. */
  value: number | null;
  unit: string;
  digits?: number;
  step?: number;
  min?: number;
  onChange: (value: number) => void;
}

/** A number that is taken over with Enter or when the field is left; arrow keys step it. */
export function NumberField({
  label,
  title,
  value,
  unit,
  digits = 2,
  step = 0.1,
  min,
  onChange,
}: NumberFieldProps) {
  const shown = value === null ? "" : trimmed(value, digits).replace("−", "-");
  const [text, setText] = useState(shown);
  useEffect(() => setText(shown), [shown]);
  const take = (typed: string) => {
    const number = Number(typed.replace(",", ".").trim());
    const valid = typed.trim() !== "" && Number.isFinite(number) && (min === undefined || number >= min);
    if (!valid) setText(shown);
    else if (typed !== shown) onChange(number);
  };
  return (
    <label className="number-field" title={title}>
      <span>{label}</span>
      <input
        type="text"
        inputMode="decimal"
        value={text}
        onChange={(event) => setText(event.target.value)}
        onBlur={() => take(text)}
        onKeyDown={(event) => {
          if (event.key === "Enter") take(text);
          if (event.key === "Escape") {
            setText(shown);
            event.currentTarget.blur();
          }
          const direction = event.key === "ArrowUp" ? 1 : event.key === "ArrowDown" ? -1 : 0;
          if (direction === 0 || value === null) return;
          event.preventDefault();
          const next = value + direction * step * (event.shiftKey ? 10 : 1);
          if (min === undefined || next >= min) onChange(next);
        }}
      />
      <span className="unit">{unit}</span>
    </label>
  );
}
