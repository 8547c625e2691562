import { useEffect, useLayoutEffect, useRef, useState } from "react";
import { remember } from "../state/remembered";
import { type Tab, useSession } from "../state/session";
import { Button } from "../ui/Button";

interface Step {
  /** `data-tour` of what it is about. */
  at: string;
  title: string;
  text: string;
  tab?: Tab;
}

const STEPS: Step[] = [
  {
    at: "prompt",
    title: "Say what you want",
    text: "Describe a garment, or drop a picture of one. About a second later there is a pattern and a garment.",
    tab: "describe",
  },
  {
    at: "chips",
    title: "See what was read",
    text: "Every word is made, assumed, or said to be impossible. Press a chip, such as the hem, and choose another: the pattern is cut to it.",
    tab: "describe",
  },
  {
    at: "pattern",
    title: "Pull on the pattern",
    text: "Drag a point, a curve or a hem. The garment follows while you drag, and Ctrl+Z takes it back.",
  },
  {
    at: "garment",
    title: "Look at the garment",
    text: "Drag to turn it. What you point at is marked in both windows. Drape it by physics when you want to be sure.",
  },
  {
    at: "adjust",
    title: "Adjust and compare",
    text: "Sliders and instructions pull the same levers as words. Every change is in the history; compare any two, and download all files.",
    tab: "adjust",
  },
];

/** Five steps on first use, which can be skipped at any time. */
export function Tour() {
  const [at, setAt] = useState(0);
  const card = useRef<HTMLDivElement>(null);
  const { set } = useSession.getState();
  const step = STEPS[at] as Step;
  const [hole, setHole] = useState<DOMRect | null>(null);

  useEffect(() => {
    if (step.tab !== undefined) set({ tab: step.tab });
  }, [step, set]);

  useLayoutEffect(() => {
    const place = () => {
      const target = document.querySelector(`[data-tour="${step.at}"]`);
      target?.scrollIntoView({ block: "nearest" });
      const box = target?.getBoundingClientRect() ?? null;
      setHole(box);
      const own = card.current;
      if (own === null) return;
      const beside = box !== null && box.right + own.offsetWidth + 28 < window.innerWidth;
      const left =
        box === null
          ? window.innerWidth / 2 - own.offsetWidth / 2
          : beside
            ? box.right + 16
            : box.left - own.offsetWidth - 16;
      const top = box === null ? 120 : box.top + 8;
      own.style.left = `${Math.max(16, Math.min(left, window.innerWidth - own.offsetWidth - 16))}px`;
      own.style.top = `${Math.max(16, Math.min(top, window.innerHeight - own.offsetHeight - 16))}px`;
    };
    const frame = requestAnimationFrame(place);
    window.addEventListener("resize", place);
    card.current?.querySelector<HTMLElement>("[data-next]")?.focus();
    return () => {
      cancelAnimationFrame(frame);
      window.removeEventListener("resize", place);
    };
  }, [step]);

  const end = () => {
    remember("toured", true);
    set({ dialog: null, tab: "describe" });
  };
  const last = at === STEPS.length - 1;
  return (
    <div className="tour">
      {hole !== null && (
        <div
          className="tour-hole"
          style={{ left: hole.left - 4, top: hole.top - 4, width: hole.width + 8, height: hole.height + 8 }}
        />
      )}
      <div
        ref={card}
        className="tour-card"
        role="dialog"
        aria-label={`Tour, step ${at + 1} of ${STEPS.length}`}
        onKeyDown={(event) => {
          if (event.key === "Escape") end();
          if (event.key === "ArrowRight" && !last) setAt(at + 1);
          if (event.key === "ArrowLeft" && at > 0) setAt(at - 1);
        }}
      >
        <p className="muted">
          {at + 1} of {STEPS.length}
        </p>
        <h2>{step.title}</h2>
        <p>{step.text}</p>
        <div className="row">
          {!last && (
            <button type="button" className="link" onClick={end}>
              Skip the tour
            </button>
          )}
          <div className="spring" />
          {at > 0 && <Button onClick={() => setAt(at - 1)}>Back</Button>}
          <Button look="primary" data-next onClick={() => (last ? end() : setAt(at + 1))}>
            {last ? "Start" : "Next"}
          </Button>
        </div>
      </div>
    </div>
  );
}
