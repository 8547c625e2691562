import { type ReactNode, useEffect, useId, useLayoutEffect, useRef, useState } from "react";

interface PopoverProps {
  /** What opens it; gets the attributes that a button with a popover needs. */
  trigger: (attributes: {
    ref: React.RefObject<HTMLButtonElement | null>;
    onClick: () => void;
    "aria-expanded": boolean;
    "aria-haspopup": "dialog" | "menu";
    "aria-controls": string | undefined;
  }) => ReactNode;
  children: (close: () => void) => ReactNode;
  label: string;
  align?: "start" | "end";
  kind?: "dialog" | "menu";
}

/** A small window at a button. Escape or a press elsewhere closes it; the focus goes back to the button. */
export function Popover({ trigger, children, label, align = "start", kind = "dialog" }: PopoverProps) {
  const [open, setOpen] = useState(false);
  const button = useRef<HTMLButtonElement>(null);
  const panel = useRef<HTMLDivElement>(null);
  const id = useId();
  const close = () => {
    setOpen(false);
    button.current?.focus();
  };

  useLayoutEffect(() => {
    const box = panel.current;
    const at = button.current?.getBoundingClientRect();
    if (!open || box === null || at === undefined) return;
    const left = align === "start" ? at.left : at.right - box.offsetWidth;
    const below = at.bottom + 6 + box.offsetHeight <= window.innerHeight || at.top < box.offsetHeight;
    box.style.left = `${Math.max(8, Math.min(left, window.innerWidth - box.offsetWidth - 8))}px`;
    box.style.top = `${below ? at.bottom + 6 : at.top - 6 - box.offsetHeight}px`;
    box.style.maxHeight = `${window.innerHeight - 24 - (below ? at.bottom : 0)}px`;
    const first =
      box.querySelector<HTMLElement>("[data-autofocus]") ??
      box.querySelector<HTMLElement>("button, input, select");
    first?.focus();
  }, [open, align]);

  useEffect(() => {
    if (!open) return;
    const press = (event: PointerEvent) => {
      const target = event.target as Node;
      if (!panel.current?.contains(target) && !button.current?.contains(target)) setOpen(false);
    };
    document.addEventListener("pointerdown", press, true);
    return () => document.removeEventListener("pointerdown", press, true);
  }, [open]);

  return (
    <>
      {trigger({
        ref: button,
        onClick: () => setOpen(!open),
        "aria-expanded": open,
        "aria-haspopup": kind,
        "aria-controls": open ? id : undefined,
      })}
      {open && (
        // biome-ignore lint/a11y/useAriaPropsSupportedByRole: both roles take a label.
        // biome-ignore lint/a11y/noStaticElementInteractions: the role is given; it listens for Escape and arrows only.
        <div
          ref={panel}
          id={id}
          className={`popover popover-${kind}`}
          role={kind}
          aria-label={label}
          onKeyDown={(event) => {
            if (event.key === "Escape") {
              event.stopPropagation();
              close();
            }
            if (kind === "menu" && (event.key === "ArrowDown" || event.key === "ArrowUp")) {
              event.preventDefault();
              const items = [...(panel.current?.querySelectorAll<HTMLElement>('[role^="menuitem"]') ?? [])];
              const now = items.indexOf(document.activeElement as HTMLElement);
              items[(now + (event.key === "ArrowDown" ? 1 : items.length - 1)) % items.length]?.focus();
            }
          }}
          onBlur={(event) => {
            if (event.relatedTarget !== null && !panel.current?.contains(event.relatedTarget)) setOpen(false);
          }}
        >
          {children(close)}
        </div>
      )}
    </>
  );
}
