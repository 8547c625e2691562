import { useRef } from "react";

interface SplitterProps {
  label: string;
  /** In the unit that the caller measures in. */
  value: number;
  min: number;
  max: number;
  step: number;
  /** By how many px the pointer has gone since it was pressed, and the value then. */
  onDrag: (px: number, from: number) => void;
  onChange: (value: number) => void;
}

/** A bar between two windows that can be dragged, or moved by the arrow keys. */
export function Splitter({ label, value, min, max, step, onDrag, onChange }: SplitterProps) {
  const start = useRef<{ x: number; value: number } | null>(null);
  return (
    // biome-ignore lint/a11y/useSemanticElements: a separator that moves is a widget, and no <hr>.
    <div
      className="splitter"
      role="separator"
      tabIndex={0}
      aria-label={label}
      aria-orientation="vertical"
      aria-valuenow={Math.round(value)}
      aria-valuemin={min}
      aria-valuemax={max}
      onPointerDown={(event) => {
        start.current = { x: event.clientX, value };
        event.currentTarget.setPointerCapture(event.pointerId);
      }}
      onPointerMove={(event) => {
        if (start.current !== null) onDrag(event.clientX - start.current.x, start.current.value);
      }}
      onPointerUp={() => {
        start.current = null;
      }}
      onPointerCancel={() => {
        start.current = null;
      }}
      onKeyDown={(event) => {
        const by = event.key === "ArrowLeft" ? -step : event.key === "ArrowRight" ? step : 0;
        if (by === 0) return;
        event.preventDefault();
        onChange(Math.min(max, Math.max(min, value + by)));
      }}
    />
  );
}
