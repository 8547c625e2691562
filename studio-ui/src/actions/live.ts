/** Lets the garment follow the pattern: every shown pattern without a garment is sewn, the latest one first. */

import { api } from "../api/client";
import type { LiveAnswer } from "../api/types";
import { garmentMesh } from "../garment/mesh-cache";
import { LatestWins } from "../state/latest-wins";
import type { PatternJson } from "../state/pattern-json";
import { carriedReading } from "../state/reading";
import { useSession } from "../state/session";
import { currentVersion, lastReading, useStudio } from "../state/store";
import { tellFailure } from "./failures";

/** Of the mesh while a garment that takes long is dragged, cm. */
const HASTY_EDGE = 3.5;
/** As the server has it without a wish. */
const FULL_EDGE = 2.5;
/** Seconds from a state to its mesh, beyond which what follows while dragging is sewn hastily. */
const SLOW = 0.2;
const client = crypto.randomUUID();
let sequence = 0;
/** Seconds that the last state took which was sewn in full. */
let fullSeconds = 0;

interface Wanted {
  pattern: PatternJson;
  startedAt: number;
  hasty: boolean;
}

async function sew({ pattern, hasty }: Wanted, signal: AbortSignal): Promise<LiveAnswer> {
  sequence += 1;
  const sentAt = performance.now();
  const how = hasty ? { edge_length: HASTY_EDGE, dragging: true } : {};
  const answer = await api.live({ client, sequence, pattern, ...how }, signal);
  // The geometry is swapped when it is all there, so that the view never shows half of one.
  if (answer.mesh !== null) await garmentMesh(answer.mesh);
  if (!hasty && answer.status === "sewn") fullSeconds = (performance.now() - sentAt) / 1000;
  return answer;
}

function show(answer: LiveAnswer, { pattern, startedAt, hasty }: Wanted): void {
  const session = useSession.getState();
  if (answer.status === "stale") return;
  session.set({
    unsewable: answer.status === "unsewable" ? answer.error : null,
    lastSewn: answer.status === "sewn" ? (performance.now() - startedAt) / 1000 : session.lastSewn,
  });
  const { draft, answerDraft, amend } = useStudio.getState();
  const { findings, seams, trims, mesh } = answer;
  if (draft !== null)
    answerDraft({
      pattern,
      findings,
      seams,
      trims,
      mesh,
      edge_length: hasty ? HASTY_EDGE : FULL_EDGE,
      hasty,
    });
  amend(pattern, {
    findings,
    seams,
    trims,
    unsewable: answer.error,
    ...(mesh && !hasty ? { mesh, garment: "sewn" as const, edge_length: FULL_EDGE } : {}),
  });
  if (draft === null) void describe(pattern);
}

const sewer = new LatestWins<Wanted, LiveAnswer>(
  sew,
  show,
  (error, { pattern }) => {
    tellFailure(error);
    useStudio.getState().amend(pattern, { findings: [], seams: [] });
  },
  (busy) => useSession.getState().set({ sewing: busy }),
);

/** Chips, sliders and a sentence for a pattern that was changed by hand. */
async function describe(pattern: PatternJson): Promise<void> {
  const shown = currentVersion(useStudio.getState());
  if (shown?.pattern !== pattern || shown.dimensions !== null) return;
  try {
    const before = lastReading(useStudio.getState());
    const answer = await api.describe(pattern);
    useStudio.getState().amend(pattern, { ...answer, reading: carriedReading(before, answer.reading) });
  } catch {
    // Words about the pattern are a convenience; the next change asks for them again.
  }
}

let lastAsked: PatternJson | null = null;
/** The last one that was asked for in full. */
let lastInFull: PatternJson | null = null;

function ask(pattern: PatternJson, hasty: boolean): void {
  lastAsked = pattern;
  if (!hasty) lastInFull = pattern;
  sewer.request({ pattern, startedAt: performance.now(), hasty });
}

/** Findings and seams of a garment that is there already, as in a project that was opened. */
async function check(pattern: PatternJson): Promise<void> {
  try {
    useStudio.getState().amend(pattern, await api.check(pattern));
  } catch (error) {
    tellFailure(error);
    useStudio.getState().amend(pattern, { findings: [], seams: [] });
  }
}

/** Sews the shown version again: its mesh is no longer to be had. */
export function sewAgain(): void {
  const version = currentVersion(useStudio.getState());
  if (version !== null) useStudio.getState().amend(version.pattern, { mesh: null, findings: null });
}

/** Starts following; returns how to end it. */
export function followPattern(): () => void {
  return useStudio.subscribe((state, before) => {
    if (state.draft !== before.draft && state.draft !== null) {
      if (state.draftAnswer?.pattern === state.draft) return;
      ask(state.draft, fullSeconds > SLOW);
      return;
    }
    const version = currentVersion(state);
    if (version === null || state.draft !== null || version === currentVersion(before)) return;
    // A drag has left a hasty garment: the full one follows.
    const unsewn = version.mesh === null && version.unsewable === null && lastInFull !== version.pattern;
    if (version.findings === null || unsewn) {
      // What the hand left last is under way already where a drag ends where it was.
      if (lastInFull === version.pattern && sewer.busy) return;
      if (version.mesh !== null) {
        lastAsked = version.pattern;
        sewer.reset();
        void check(version.pattern);
      } else ask(version.pattern, false);
    } else {
      if (version.pattern !== currentVersion(before)?.pattern) {
        if (lastAsked !== version.pattern) sewer.reset();
        useSession.getState().set({ unsewable: version.mesh === null ? version.unsewable : null });
      }
      if (version.dimensions === null) void describe(version.pattern);
    }
  });
}
