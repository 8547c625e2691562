import { useStudio } from "../state/store";

/** Stands where the pattern window goes. */
export function PatternPane() {
  const empty = useStudio((state) => state.history === null);
  return <div className="pane">{empty ? "Nothing is open" : ""}</div>;
}
