/** What the server says, the job at work, messages and dialogs: everything that a reload may forget. */

import { create } from "zustand";
import type { Document, Job, State } from "../api/types";
import type { Outfit } from "./outfit";

export interface Notice {
  id: number;
  kind: "ok" | "info" | "warning" | "error";
  message: string;
  /** What to do next. */
  hint: string;
  action: { label: string; run: () => void } | null;
}

export type Dialog = "shortcuts" | "projects" | "compare" | "tour" | null;
export type Tab = "describe" | "adjust" | "body" | "history";

export interface SessionState {
  server: State | null;
  /** null while the first answer is awaited. */
  connected: boolean | null;
  job: Job | null;
  /** What the job is for, as the progress says it. */
  jobTitle: string;
  /** Latest frame of a drape: positions of welded vertices, and the mesh that they are of. */
  frame: { mesh: string; number: number; positions: Float32Array } | null;
  /** Garments to choose from. */
  variants: Document[] | null;
  /** Both garments of words that asked for two. */
  outfit: Outfit | null;
  notices: Notice[];
  dialog: Dialog;
  tab: Tab;
  /** Quick work under way, such as "Recutting". */
  working: string | null;
  /** Live sewing: whether an answer is awaited, and the seconds the last one took. */
  sewing: boolean;
  lastSewn: number | null;
  /** Why the pattern cannot be sewn as it is drawn. */
  unsewable: { message: string; hint: string } | null;
  set: (change: Partial<Omit<SessionState, "set">>) => void;
}

export const useSession = create<SessionState>()((set) => ({
  server: null,
  connected: null,
  job: null,
  jobTitle: "",
  frame: null,
  variants: null,
  outfit: null,
  notices: [],
  dialog: null,
  tab: "describe",
  working: null,
  sewing: false,
  lastSewn: null,
  unsewable: null,
  set: (change) => set(change),
}));

let lastNotice = 0;

/** Shows a message; those that are no problem go by themselves. */
export function notify(
  kind: Notice["kind"],
  message: string,
  hint = "",
  action: Notice["action"] = null,
): number {
  lastNotice += 1;
  const id = lastNotice;
  const { notices, set } = useSession.getState();
  const others = notices.filter((each) => each.message !== message);
  set({ notices: [...others.slice(-3), { id, kind, message, hint, action }] });
  if (kind !== "error") setTimeout(() => dismiss(id), kind === "warning" || action !== null ? 10_000 : 4500);
  return id;
}

export function dismiss(id: number): void {
  const { notices, set } = useSession.getState();
  set({ notices: notices.filter((each) => each.id !== id) });
}
