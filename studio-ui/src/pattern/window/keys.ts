/** Keys of the pattern window, while it has the focus. */

import { useStudio } from "../../state/store";
import type { Point } from "../specification";
import {
  addPointsToSelected,
  arrangeAnew,
  deleteSelected,
  fitAll,
  nudge,
  rotateSelected,
  selectAll,
  sewSelected,
  zoomToSelection,
} from "./commands";
import { usePatternView } from "./pattern-view-state";
import { PX_PER_CM_TRUE, zoomedAt } from "./view";

export const PATTERN_KEYS: readonly { keys: string; does: string }[] = [
  { keys: "Tab", does: "next panel, point or edge" },
  { keys: "Enter", does: "go into a panel" },
  { keys: "Arrow keys", does: "move what is selected by 0.1 cm" },
  { keys: "Shift+Arrow keys", does: "by 1 cm" },
  { keys: "Delete", does: "delete points, remove stitches" },
  { keys: "A", does: "add a point to the middle of the edge" },
  { keys: "S", does: "sew: two selected edges, or the next two you choose" },
  { keys: "V, P, G", does: "tools: select, add points, move the sheet" },
  { keys: "M", does: "mirror editing on or off" },
  { keys: "N", does: "snapping on or off; hold Ctrl to switch it off for one drag" },
  { keys: "H", does: "whole hem or single edge" },
  { keys: "R, Shift+R", does: "turn the panel in the window" },
  { keys: "T", does: "arrange the panels anew" },
  { keys: "F, Z", does: "show everything, or what is selected" },
  { keys: "+ and −, 1", does: "nearer, farther, true size" },
  { keys: "Alt+drag", does: "bend an edge" },
  { keys: "Double-click", does: "add a point to an edge" },
];

const STEP_CM = { small: 0.1, large: 1 };
const STEP_INCH = { small: 2.54 / 16, large: 2.54 };
const ZOOM = 1.25;

/** What a key does, or null where it does nothing here. */
export function commandFor(event: {
  key: string;
  shiftKey: boolean;
  ctrlKey: boolean;
  metaKey: boolean;
  altKey: boolean;
}): (() => void) | null {
  const { set, flip, view, size, tool } = usePatternView.getState();
  const { units, selection, select, draft } = useStudio.getState();
  if (event.ctrlKey || event.metaKey) return event.key.toLowerCase() === "a" ? selectAll : null;
  if (event.altKey) return null;
  const steps = units === "cm" ? STEP_CM : STEP_INCH;
  const step = event.shiftKey ? steps.large : steps.small;
  const middle: Point = [size[0] / 2, size[1] / 2];
  const zoom = (factor: number) => () => set({ view: zoomedAt(view, middle, factor) });
  switch (event.key.length === 1 ? event.key.toLowerCase() : event.key) {
    case "ArrowUp":
      return () => nudge([0, step]);
    case "ArrowDown":
      return () => nudge([0, -step]);
    case "ArrowLeft":
      return () => nudge([-step, 0]);
    case "ArrowRight":
      return () => nudge([step, 0]);
    case "Delete":
    case "Backspace":
      return deleteSelected;
    case "a":
      return addPointsToSelected;
    case "s":
      return sewSelected;
    case "v":
      return () => set({ tool: "select", sewFrom: null, ghost: null });
    case "p":
      return () => set({ tool: "point", sewFrom: null });
    case "g":
      return () => set({ tool: "pan", sewFrom: null, ghost: null });
    case "m":
      return () => flip("mirror");
    case "n":
      return () => flip("snap");
    case "h":
      return () => flip("hem");
    case "r":
      return () => rotateSelected(event.shiftKey ? 15 : -15);
    case "t":
      return arrangeAnew;
    case "f":
    case "0":
    case "Home":
      return fitAll;
    case "z":
      return zoomToSelection;
    case "+":
    case "=":
      return zoom(ZOOM);
    case "-":
      return zoom(1 / ZOOM);
    case "1":
      return zoom(PX_PER_CM_TRUE / view.scale);
    case "Escape":
      // A drag is the shell's to cancel; a tool is ours to put down.
      if (draft !== null) return null;
      if (tool !== "select") return () => set({ tool: "select", sewFrom: null, ghost: null });
      return selection.length > 0 ? () => select(null) : null;
    default:
      return null;
  }
}
