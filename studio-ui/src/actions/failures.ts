import { ApiError } from "../api/client";
import { notify } from "../state/session";

/** Shows what went wrong, in the server's words; aborted requests are no failure. */
export function tellFailure(error: unknown, retry: (() => void) | null = null): void {
  if (error instanceof DOMException && error.name === "AbortError") return;
  const action = retry === null ? null : { label: "Try again", run: retry };
  if (error instanceof ApiError) {
    const wait =
      error.retryAfter !== null && error.info.hint === "" ? `Try again in ${error.retryAfter} s.` : "";
    notify("error", error.info.message, error.info.hint || wait, action);
  } else {
    notify("error", error instanceof Error ? error.message : String(error), "", action);
  }
}
