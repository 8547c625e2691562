/** Requests to the studio's server. All of them are relative to the page: nothing goes to another host. */

import type {
  AlterRequest,
  BodyAnswer,
  CheckAnswer,
  DescribeAnswer,
  Document,
  ErrorAnswer,
  ErrorInfo,
  ExportRequest,
  FileInfo,
  FitRequest,
  Job,
  JobRequest,
  LiveAnswer,
  LiveRequest,
  MeasuresAnswer,
  MeasuresRequest,
  OpenRequest,
  PatternJson,
  Project,
  ProjectContent,
  ProjectSummary,
  RepairAnswer,
  SavedAnswer,
  State,
  WearerAnswer,
} from "./types";

/** What went wrong and what to do next; both are for people. */
export class ApiError extends Error {
  constructor(
    readonly info: ErrorInfo,
    readonly status: number,
    /** Seconds to wait before another try, where the server says so. */
    readonly retryAfter: number | null = null,
  ) {
    super(info.message);
  }
}

const OFFLINE: ErrorInfo = {
  code: "unreachable",
  message: "The studio's server does not answer.",
  hint: "Look whether `swifttailor studio` still runs in its terminal, and start it again if not. Your work stays in this window.",
};

interface Ask {
  method?: "GET" | "POST" | "PUT" | "DELETE";
  json?: unknown;
  bytes?: Blob;
  signal?: AbortSignal;
}

async function ask(path: string, { method = "GET", json, bytes, signal }: Ask = {}): Promise<Response> {
  const headers: Record<string, string> = {};
  if (json !== undefined) headers["Content-Type"] = "application/json";
  else if (bytes !== undefined) headers["Content-Type"] = bytes.type;
  const body = json !== undefined ? JSON.stringify(json) : bytes;
  let answer: Response;
  try {
    answer = await fetch(path, {
      method,
      headers,
      ...(body !== undefined ? { body } : {}),
      ...(signal ? { signal } : {}),
    });
  } catch (error) {
    if (error instanceof DOMException && error.name === "AbortError") throw error;
    throw new ApiError(OFFLINE, 0);
  }
  if (answer.ok) return answer;
  throw new ApiError(await errorOf(answer), answer.status, Number(answer.headers.get("Retry-After")) || null);
}

async function errorOf(answer: Response): Promise<ErrorInfo> {
  try {
    const { error } = (await answer.json()) as ErrorAnswer;
    if (typeof error?.message === "string") return error;
  } catch {
    // Not the server's own words; what follows says what is known.
  }
  const message = `The server answered ${answer.status} without saying why.`;
  return { code: "unknown", message, hint: "Look into the terminal in which the studio runs." };
}

async function ofJson<T>(path: string, what: Ask = {}): Promise<T> {
  return (await ask(path, what)).json() as Promise<T>;
}

const id = encodeURIComponent;

export const api = {
  session: (token: string) =>
    fetch("/api/session", { method: "POST", headers: { Authorization: `Bearer ${token}` } }),
  state: () => ofJson<State>("/api/state"),
  example: (name: string) => ofJson<Document>(`/api/examples/${id(name)}`),
  open: (json: OpenRequest) => ofJson<Document>("/api/open", { method: "POST", json }),
  live: (json: LiveRequest, signal: AbortSignal) =>
    ofJson<LiveAnswer>("/api/live", { method: "POST", json, signal }),
  check: (pattern: PatternJson) => ofJson<CheckAnswer>("/api/check", { method: "POST", json: { pattern } }),
  repair: (pattern: PatternJson) =>
    ofJson<RepairAnswer>("/api/repair", { method: "POST", json: { pattern } }),
  describe: (pattern: PatternJson) =>
    ofJson<DescribeAnswer>("/api/describe", { method: "POST", json: { pattern } }),
  fit: (json: FitRequest) => ofJson<Document>("/api/fit", { method: "POST", json }),
  wearer: (pattern: PatternJson) =>
    ofJson<WearerAnswer>("/api/wearer", { method: "POST", json: { pattern } }),
  measures: (json: MeasuresRequest) => ofJson<MeasuresAnswer>("/api/measures", { method: "POST", json }),
  alter: (json: AlterRequest) => ofJson<Document>("/api/alter", { method: "POST", json }),

  startJob: (json: JobRequest) => ofJson<Job>("/api/jobs", { method: "POST", json }),
  job: (job: string) => ofJson<Job>(`/api/jobs/${id(job)}`),
  cancelJob: (job: string) => ofJson<Job>(`/api/jobs/${id(job)}`, { method: "DELETE" }),
  jobEvents: (job: string) => new EventSource(`/api/jobs/${id(job)}/events`),
  /** Positions of the welded vertices, (welded, 3) in cm. */
  frame: async (job: string) =>
    new Float32Array(await (await ask(`/api/jobs/${id(job)}/frame`)).arrayBuffer()),

  mesh: async (name: string) => (await ask(`/api/meshes/${id(name)}`)).arrayBuffer(),
  body: async (name: string) => (await ask(`/api/body/${id(name)}`)).arrayBuffer(),

  /** One repeat of a print, and the matrix, row by row, from cm of the cloth to repeats. */
  tile: async (query: URLSearchParams) => {
    const answer = await ask(`/api/prints/tile?${query}`);
    const matrix = (answer.headers.get("X-Tile") ?? "").split(" ").map(Number);
    return { picture: await answer.blob(), matrix };
  },

  sendBody: (file: File) =>
    ofJson<BodyAnswer>(`/api/bodies?file_name=${id(file.name.slice(-200))}`, {
      method: "POST",
      bytes: file.slice(0, file.size, "application/octet-stream"),
    }),
  sendPicture: (bytes: Blob) => ofJson<FileInfo>("/api/files", { method: "POST", bytes }),

  projects: () => ofJson<ProjectSummary[]>("/api/projects"),
  project: (name: string) => ofJson<Project>(`/api/projects/${id(name)}`),
  createProject: (content: ProjectContent) =>
    ofJson<Project>("/api/projects", { method: "POST", json: { content } }),
  saveProject: (name: string, revision: number, content: ProjectContent) =>
    ofJson<SavedAnswer>(`/api/projects/${id(name)}`, { method: "PUT", json: { revision, content } }),
  draftProject: (name: string, revision: number, content: ProjectContent) =>
    ofJson<SavedAnswer>(`/api/projects/${id(name)}/draft`, { method: "PUT", json: { revision, content } }),
  deleteProject: async (name: string) => {
    await ask(`/api/projects/${id(name)}`, { method: "DELETE" });
  },
  restoreProject: (name: string) =>
    ofJson<ProjectSummary>(`/api/trash/${id(name)}/restore`, { method: "POST" }),

  /** The file and the name that the server gives it. */
  exported: async (json: ExportRequest) => {
    const answer = await ask("/api/export", { method: "POST", json });
    const name = /filename="?([^";]+)"?/.exec(answer.headers.get("Content-Disposition") ?? "")?.[1];
    return { name: name ?? `garment.${json.format}`, blob: await answer.blob() };
  },
};
