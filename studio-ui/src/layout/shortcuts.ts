/** Keys of the whole studio. Windows have their own while they have the focus. */

import { generate } from "../actions/generate";
import { cancelJob } from "../actions/jobs";
import { saveProject } from "../actions/projects";
import { PATTERN_KEYS } from "../pattern/window/keys";
import { useDisplay } from "../state/display";
import { useSession } from "../state/session";
import { useStudio } from "../state/store";

export interface Shortcut {
  keys: string;
  does: string;
}

export const SHORTCUTS: { where: string; list: readonly Shortcut[] }[] = [
  {
    where: "Everywhere",
    list: [
      { keys: "?", does: "this list" },
      { keys: "Ctrl+Z", does: "undo" },
      { keys: "Ctrl+Shift+Z or Ctrl+Y", does: "redo" },
      { keys: "Ctrl+S", does: "save the project" },
      { keys: "Ctrl+O", does: "open a project or a file" },
      { keys: "Ctrl+Enter", does: "make the garment that is described" },
      { keys: "Esc", does: "close what is open, cancel a drag, clear the selection" },
      { keys: "C", does: "compare two versions" },
      { keys: "D", does: "light or dark" },
      { keys: "[", does: "hide or show the left column" },
      { keys: "\\", does: "one window or both" },
      { keys: "Ctrl+V", does: "paste a picture" },
    ],
  },
  { where: "Pattern window", list: PATTERN_KEYS },
  {
    where: "Garment window",
    list: [
      { keys: "Arrow keys", does: "orbit" },
      { keys: "Shift+Arrow keys", does: "move the view" },
      { keys: "+ and −", does: "nearer, farther" },
      { keys: "1, 2, 3, 4", does: "front, back, left side, right side" },
      { keys: "0 or Home", does: "all of the garment" },
      { keys: "B", does: "body on or off" },
      { keys: "W", does: "wireframe" },
      { keys: "N", does: "normals: which way the cloth faces" },
      { keys: "S", does: "seams" },
      { keys: "X", does: "next colouring: cloth, panels, strain" },
    ],
  },
];

/** Listens until the returned function is called. */
export function listenForShortcuts(): () => void {
  const listener = (event: KeyboardEvent) => {
    const command = event.ctrlKey || event.metaKey;
    const target = event.target as HTMLElement;
    const typing = target.matches(
      "input:not([type=range]):not([type=checkbox]):not([type=radio]), textarea, select, [contenteditable]",
    );
    if (document.querySelector("dialog[open]") !== null) return;
    const does = command ? withControl(event, typing) : typing || event.altKey ? null : plain(event);
    if (does === null) return;
    event.preventDefault();
    does();
  };
  document.addEventListener("keydown", listener);
  return () => document.removeEventListener("keydown", listener);
}

function withControl(event: KeyboardEvent, typing: boolean): (() => void) | null {
  const key = event.key.toLowerCase();
  const { undo, redo } = useStudio.getState();
  if (key === "s") return () => void saveProject();
  if (key === "o") return () => useSession.getState().set({ dialog: "projects" });
  if (key === "enter") return () => void generate();
  // Where something is typed, undo is the field's own.
  if (typing) return null;
  if (key === "z") return event.shiftKey ? redo : undo;
  if (key === "y") return redo;
  return null;
}

function plain(event: KeyboardEvent): (() => void) | null {
  if (event.defaultPrevented) return null;
  const { set, job } = useSession.getState();
  const display = useDisplay.getState();
  const { theme, setTheme, history } = useStudio.getState();
  switch (event.key) {
    case "?":
      return () => set({ dialog: "shortcuts" });
    case "c":
      return history !== null && history.entries.length > 1 ? () => set({ dialog: "compare" }) : null;
    case "d":
      return () => setTheme(theme === "dark" ? "light" : "dark");
    case "[":
      return () => display.change({ sidebar: !display.sidebar });
    case "\\": {
      const next = { both: "pattern", pattern: "garment", garment: "both" } as const;
      return () => display.change({ layout: next[display.layout] });
    }
    case "Escape":
      if (useStudio.getState().draft !== null) return () => useStudio.getState().cancelPreview();
      if (job?.state === "queued") return () => void cancelJob();
      return () => useStudio.getState().select(null);
    default:
      return null;
  }
}
