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

const client = crypto.randomUUID();
let sequence = 0;

async function sew(pattern: PatternJson, signal: AbortSignal): Promise<LiveAnswer> {
  sequence += 1;
  const answer = await api.live({ client, sequence, pattern }, signal);
  // The geometry is swapped when it is all there, so that the view never shows half of one.
  if (answer.mesh !== null) await garmentMesh(answer.mesh);
  return answer;
}

function show(answer: LiveAnswer, pattern: PatternJson, startedAt: number): void {
  const session = useSession.getState();
  if (answer.status === "stale") return;
  session.set({
    unsewable: answer.status === "unsewable" ? answer.error : null,
    lastSewn: answer.status === "sewn" ? (performance.now() - startedAt) / 1000 : session.lastSewn,
  });
  const { draft, answerDraft, amend } = useStudio.getState();
  const { findings, seams, mesh } = answer;
  if (draft !== null) answerDraft({ pattern, findings, seams, mesh });
  amend(pattern, {
    findings,
    seams,
    unsewable: answer.error,
    ...(mesh ? { mesh, garment: "sewn" as const } : {}),
  });
  if (draft === null) void describe(pattern);
}

const sewer = new LatestWins<{ pattern: PatternJson; startedAt: number }, LiveAnswer>(
  (state, signal) => sew(state.pattern, signal),
  (answer, state) => show(answer, state.pattern, state.startedAt),
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
      lastAsked = state.draft;
      sewer.request({ pattern: state.draft, startedAt: performance.now() });
      return;
    }
    const version = currentVersion(state);
    if (version === null || state.draft !== null || version === currentVersion(before)) return;
    if (version.findings === null) {
      // What the hand left last is under way already where a drag ends where it was.
      if (lastAsked === version.pattern && sewer.busy) return;
      lastAsked = version.pattern;
      if (version.mesh !== null) {
        sewer.reset();
        void check(version.pattern);
      } else sewer.request({ pattern: version.pattern, startedAt: performance.now() });
    } else {
      if (version.pattern !== currentVersion(before)?.pattern) {
        if (lastAsked !== version.pattern) sewer.reset();
        useSession.getState().set({ unsewable: version.mesh === null ? version.unsewable : null });
      }
      if (version.dimensions === null) void describe(version.pattern);
    }
  });
}
