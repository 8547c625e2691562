import type { Document } from "../api/types";
import { versionOf } from "../state/document";
import { randomSeed, usePrompt } from "../state/prompt";
import { notify, useSession } from "../state/session";
import { currentVersion, useStudio } from "../state/store";
import { sentenceCase } from "../ui/sentence-case";
import { runJob } from "./jobs";
import { outfitOf } from "./outfit";
import { newProject } from "./projects";
import { wearerNamed } from "./wearers";

/** Makes a garment, or four to choose from, of the words and pictures. */
export async function generate(): Promise<void> {
  const prompt = usePrompt.getState();
  const text = prompt.text.trim();
  if (text === "" && prompt.pictures.length === 0) {
    notify("info", "Describe a garment, or drop a picture of one.", "Or start with one of the examples.");
    return;
  }
  if (!prompt.keepSeed) prompt.set({ seed: randomSeed() });
  const { seed, variants, finish, part, pictures } = usePrompt.getState();
  const wearer = wearerNamed(currentVersion(useStudio.getState())?.pattern ?? null);
  const job = await runJob(variants > 1 ? `Making ${variants} garments` : "Making the garment", {
    kind: "generate",
    ...(text !== "" ? { text } : {}),
    ...(pictures.length > 0 ? { pictures: pictures.map((each) => each.id) } : {}),
    ...(part !== null ? { part } : {}),
    seed,
    variants,
    finish,
    ...(wearer !== null ? { wearer } : {}),
  });
  if (job === null) return;
  const [first, ...others] = job.documents;
  for (const { error } of job.failures) notify("warning", error.message, error.hint);
  if (first === undefined) return;
  const isChoice = variants > 1 && others.length > 0;
  if (isChoice) useSession.getState().set({ variants: job.documents });
  else openChosen(first, job.documents);
}

/** Shows a garment of those that were made together; the other of two that are worn together waits beside it. */
export function openChosen(document: Document, made: Document[]): void {
  openMade(document);
  useSession.getState().set({ outfit: outfitOf(made, document) });
}

/** Shows a garment that was made as a new project. */
export function openMade(document: Document): void {
  useSession.getState().set({ variants: null });
  const title = document.prompt === "" ? "Garment from a picture" : document.title;
  newProject(sentenceCase(title));
  useStudio
    .getState()
    .open(document.prompt !== "" ? "Made from words" : "Made from a picture", versionOf(document));
  if (document.seed !== null) usePrompt.getState().set({ seed: document.seed });
}
