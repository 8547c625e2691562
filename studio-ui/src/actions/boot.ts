/** The first seconds: session, what the server says, and a finished garment in both windows. */

import { ApiError, api } from "../api/client";
import type { Example } from "../api/types";
import { versionOf } from "../state/document";
import { usePrompt } from "../state/prompt";
import { remembered } from "../state/remembered";
import { useSession } from "../state/session";
import { useStudio } from "../state/store";
import { tellFailure } from "./failures";
import { followPattern } from "./live";
import { goOn, newProject, openProject, startAutosave } from "./projects";

export async function boot(): Promise<void> {
  followPattern();
  startAutosave();
  const { set } = useSession.getState();
  try {
    await startSession();
    const server = await api.state();
    set({ server, connected: true });
    const linked = new URLSearchParams(location.hash.slice(1)).get("project");
    const wentOn = linked !== null ? await openProject(linked) : await goOn();
    const first = server.examples[0];
    if (!wentOn && first !== undefined) await openExample(first);
    if (!remembered("toured", false)) set({ dialog: "tour" });
    if (!server.ready) waitUntilReady();
  } catch (error) {
    set({ connected: false });
    if (!(error instanceof ApiError && error.status === 0)) tellFailure(error);
  }
}

/** The token in the address's fragment becomes a cookie, and leaves the address. */
async function startSession(): Promise<void> {
  const fragment = new URLSearchParams(location.hash.slice(1));
  const token = fragment.get("token");
  if (token === null) return;
  const answer = await api.session(token);
  if (!answer.ok) {
    const message = "This address does not open the studio.";
    throw new ApiError(
      {
        code: "token",
        message,
        hint: "Use the whole address that `swifttailor studio` printed in its terminal.",
      },
      answer.status,
    );
  }
  fragment.delete("token");
  const rest = fragment.toString();
  history.replaceState(null, "", location.pathname + (rest ? `#${rest}` : ""));
}

export async function openExample(example: Example): Promise<void> {
  const { set } = useSession.getState();
  set({ working: "Opening the example", variants: null });
  try {
    const document = await api.example(example.id);
    newProject(example.title);
    useStudio.getState().open(`Example: ${example.title}`, versionOf(document));
    usePrompt.getState().set({ text: example.prompt, pictures: [], seed: document.seed ?? 0 });
  } catch (error) {
    tellFailure(error, () => void openExample(example));
  } finally {
    set({ working: null });
  }
}

/** Tries again until the server answers. */
export async function reconnect(): Promise<void> {
  const { set } = useSession.getState();
  set({ connected: null });
  try {
    set({ server: await api.state(), connected: true });
  } catch {
    set({ connected: false });
  }
}

function waitUntilReady(): void {
  const timer = setInterval(async () => {
    try {
      const server = await api.state();
      useSession.getState().set({ server });
      if (server.ready) clearInterval(timer);
    } catch {
      clearInterval(timer);
    }
  }, 2000);
}
