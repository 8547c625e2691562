/** Projects: saved on the server as folders; what is not saved yet is kept in the browser. */

import { ApiError, api } from "../api/client";
import type { Project, ProjectContent, ProjectSummary } from "../api/types";
import { arrangementOf } from "../pattern/layout/arrangement";
import { changedVersion, documentOf, type Version, versionOf } from "../state/document";
import type { History } from "../state/history";
import { fromWire } from "../state/pattern-json";
import { UNTITLED, useProject } from "../state/project";
import { usePrompt } from "../state/prompt";
import { remember, remembered } from "../state/remembered";
import { notify, useSession } from "../state/session";
import { currentVersion, useStudio } from "../state/store";
import { tellFailure } from "./failures";

const AUTOSAVE_MS = 1500;
const KEPT_IN_BROWSER = 20;

/** Where this window goes on after a reload. */
type LastOpen = { project: string } | { unsaved: ProjectContent };

/** What is opened next belongs to no project yet. */
export function newProject(name: string): void {
  useProject.getState().set({ id: null, name: name || UNTITLED, folder: null, revision: 0, save: "saved" });
  useSession.getState().set({ outfit: null });
}

function contentNow(): ProjectContent | null {
  const { history, units } = useStudio.getState();
  const version = currentVersion(useStudio.getState());
  if (history === null || version === null) return null;
  const most = useSession.getState().server?.limits.project_versions ?? 50;
  const first = Math.max(0, Math.min(history.entries.length - most, history.index));
  const entries = history.entries.slice(first, first + most);
  return {
    name: useProject.getState().name,
    prompt: version.prompt,
    seed: version.seed,
    document: documentOf(version),
    versions: entries.map(({ label, at, value }, k) => ({
      number: k + 1,
      label,
      saved: new Date(at).toISOString(),
      pattern: value.pattern,
      mesh: value.mesh,
      color: value.color,
      ...(value.looks !== undefined ? { looks: value.looks } : {}),
      print: value.print ?? null,
      seed: value.seed,
    })),
    view: {
      index: history.index - first,
      units,
      prompt: usePrompt.getState().text,
      ...(version.arrangement !== undefined ? { arrangement: version.arrangement } : {}),
    },
  };
}

/** Saves the project, under its name; makes it where it is new. */
export async function saveProject(): Promise<void> {
  const content = contentNow();
  if (content === null) return;
  const project = useProject.getState();
  const history = useStudio.getState().history;
  project.set({ save: "saving" });
  try {
    if (project.id === null) {
      const made = await api.createProject(content);
      project.set({ id: made.id, folder: made.folder, revision: made.revision });
    } else {
      const saved = await api.saveProject(project.id, project.revision, content);
      project.set({ revision: saved.revision });
    }
    project.set({ save: useStudio.getState().history === history ? "saved" : "unsaved" });
    keepPlace();
    notify("ok", `Saved "${content.name}".`);
  } catch (error) {
    project.set({ save: "failed" });
    if (error instanceof ApiError && error.info.code === "project-changed")
      notify("error", error.info.message, error.info.hint, {
        label: "Save as a new project",
        run: () => void saveCopy(),
      });
    else tellFailure(error, () => void saveProject());
  }
}

/** Saves what is shown as another project. */
export async function saveCopy(): Promise<void> {
  useProject.getState().set({ id: null, revision: 0 });
  await saveProject();
}

export async function openProject(id: string): Promise<boolean> {
  try {
    const project = await api.project(id);
    show(project, project.draft ?? project);
    if (project.draft !== null) {
      useProject.getState().set({ save: "autosaved" });
      notify("info", "Went on from what was autosaved.", "", {
        label: "Open what was saved",
        run: () => show(project, project),
      });
    }
    keepPlace();
    return true;
  } catch (error) {
    tellFailure(error);
    return false;
  }
}

export async function deleteProject(project: ProjectSummary): Promise<void> {
  await api.deleteProject(project.id);
  if (useProject.getState().id === project.id)
    useProject.getState().set({ id: null, revision: 0, save: "unsaved" });
  notify("info", `"${project.name}" is in the trash.`, "", {
    label: "Bring it back",
    run: () => void api.restoreProject(project.id).then(refreshProjects, tellFailure),
  });
  await refreshProjects();
}

export async function refreshProjects(): Promise<void> {
  const { server, set } = useSession.getState();
  if (server !== null) set({ server: { ...server, projects: await api.projects() } });
}

/** After a reload: the project, or what was not saved. Resolves with whether there was anything. */
export async function goOn(): Promise<boolean> {
  const last = lastOpen();
  if (last === null) return false;
  if ("project" in last) return openProject(last.project);
  restoreContent(last.unsaved);
  newProject(last.unsaved.name);
  useProject.getState().set({ save: "unsaved" });
  return true;
}

/** Autosaves after each change; returns how to end it. */
export function startAutosave(): () => void {
  let timer: ReturnType<typeof setTimeout> | undefined;
  const changed = () => {
    const project = useProject.getState();
    if (project.save === "saved" || project.save === "autosaved") project.set({ save: "unsaved" });
    clearTimeout(timer);
    timer = setTimeout(() => void autosave(), AUTOSAVE_MS);
  };
  const endStudio = useStudio.subscribe((state, before) => {
    if (state.history === null || state.history === before.history) return;
    const patterns = (history: History<Version> | null) =>
      history?.entries.map(({ id, value }) => `${id} ${value.color}`).join();
    const moved = state.history.index !== before.history?.index;
    if (moved || patterns(state.history) !== patterns(before.history)) changed();
  });
  const endProject = useProject.subscribe((state, before) => {
    if (state.name !== before.name && state.id === before.id) changed();
  });
  window.addEventListener("pagehide", keepPlace);
  return () => {
    window.removeEventListener("pagehide", keepPlace);
    endStudio();
    endProject();
    clearTimeout(timer);
  };
}

async function autosave(): Promise<void> {
  const project = useProject.getState();
  keepPlace();
  if (project.id === null || project.save === "saved") return;
  const content = contentNow();
  if (content === null) return;
  try {
    await api.draftProject(project.id, project.revision, content);
    if (useProject.getState().save === "unsaved") project.set({ save: "autosaved" });
  } catch {
    project.set({ save: "failed" });
  }
}

function show(project: Project, content: ProjectContent): void {
  restoreContent(content);
  const { id, folder, revision } = project;
  useSession.getState().set({ outfit: null });
  useProject.getState().set({ id, folder, revision, name: content.name, save: "saved" });
}

function restoreContent(content: ProjectContent): void {
  const arrangement = arrangementOf(content.view.arrangement);
  const shown: Version = {
    ...versionOf(content.document),
    ...(arrangement !== null ? { arrangement } : {}),
  };
  const index = Number(content.view.index ?? content.versions.length - 1);
  const entries = content.versions.map((version, k) => ({
    id: -(k + 1),
    label: version.label,
    at: Date.parse(version.saved) || Date.now(),
    value:
      k === index
        ? shown
        : {
            ...changedVersion(shown, fromWire(version.pattern)),
            mesh: version.mesh,
            color: version.color,
            ...(version.looks !== undefined ? { looks: version.looks } : {}),
            print: version.print ?? null,
            seed: version.seed,
            garment: version.mesh === null ? ("none" as const) : ("sewn" as const),
          },
  }));
  const inside = index >= 0 && index < entries.length;
  useStudio
    .getState()
    .restore(
      inside
        ? { entries, index }
        : { entries: [{ id: -1, label: "Opened", at: Date.now(), value: shown }], index: 0 },
    );
  usePrompt.getState().set({ text: String(content.view.prompt ?? content.prompt), seed: content.seed ?? 0 });
}

function keepPlace(): void {
  const { id } = useProject.getState();
  const content = id === null ? contentNow() : null;
  if (content !== null) {
    const dropped = Math.max(0, content.versions.length - KEPT_IN_BROWSER);
    content.versions = content.versions.slice(dropped);
    content.view.index = Math.max(0, Number(content.view.index) - dropped);
  }
  const last: LastOpen | null =
    id !== null ? { project: id } : content !== null ? { unsaved: content } : null;
  remember("last", last);
  try {
    // Of two windows each goes on with its own garment.
    if (last !== null) sessionStorage.setItem("swifttailor.last", JSON.stringify(last));
  } catch {
    // Then both go on with the last one.
  }
}

function lastOpen(): LastOpen | null {
  try {
    const own = sessionStorage.getItem("swifttailor.last");
    if (own !== null) return JSON.parse(own) as LastOpen;
  } catch {
    // Fall through to what all windows share.
  }
  return remembered<LastOpen | null>("last", null);
}
