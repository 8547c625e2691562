import { api } from "../api/client";
import { fromWire } from "../state/pattern-json";
import { notify, useSession } from "../state/session";
import { shownPattern, useStudio } from "../state/store";
import { tellFailure } from "./failures";

/** Repairs what can be repaired safely, as one entry in the history. */
export async function mend(): Promise<void> {
  const pattern = shownPattern(useStudio.getState());
  if (pattern === null) return;
  const session = useSession.getState();
  session.set({ working: "Mending" });
  try {
    const answer = await api.repair(pattern);
    if (answer.changes.length === 0) {
      notify(
        "info",
        "Nothing here can be mended by itself.",
        "Select a finding to see its place, and move its points.",
      );
      return;
    }
    useStudio.getState().apply("Mend the pattern", fromWire(answer.pattern));
    notify(
      "ok",
      answer.changes.length === 1
        ? `Mended: ${answer.changes[0]}`
        : `Mended ${answer.changes.length} faults.`,
    );
  } catch (error) {
    tellFailure(error, () => void mend());
  } finally {
    session.set({ working: null });
  }
}
