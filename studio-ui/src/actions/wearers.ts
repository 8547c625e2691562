/** Who wears a pattern: the body that the pattern names, fetched once. */

import { ApiError, api } from "../api/client";
import type { Figure, WearerAnswer, WearerRef } from "../api/types";
import { bodyMesh } from "../garment/mesh-cache";
import type { MeshData } from "../garment/mesh-file";
import type { PatternJson } from "../state/pattern-json";
import { useSession } from "../state/session";

const known = new Map<string, Promise<WearerAnswer>>();

/** The body that a pattern names; null for the default one. */
export function wearerNamed(pattern: PatternJson | null): WearerRef | null {
  const named = pattern?.properties?.drafted_for as WearerRef | null | undefined;
  return named ?? null;
}

/** The same for patterns of the same wearer, and only for these. */
export function wearerKey(pattern: PatternJson | null): string {
  return JSON.stringify(wearerNamed(pattern));
}

/** All that is known of who wears a pattern. */
export function wearerOf(pattern: PatternJson | null): Promise<WearerAnswer> {
  const named = wearerNamed(pattern);
  if (pattern === null || named === null) return Promise.resolve(defaultWearer());
  const key = wearerKey(pattern);
  const before = known.get(key);
  if (before !== undefined) return before;
  const asked = api.wearer(pattern);
  known.set(key, asked);
  asked.catch(() => known.delete(key));
  return asked;
}

/** The mesh of who wears a pattern; made again where the server no longer keeps it. */
export async function bodyOf(pattern: PatternJson | null): Promise<MeshData> {
  const { body } = await wearerOf(pattern);
  try {
    return await bodyMesh(body);
  } catch (error) {
    if (!(error instanceof ApiError) || error.status !== 404 || !known.delete(wearerKey(pattern)))
      throw error;
    return bodyMesh((await wearerOf(pattern)).body);
  }
}

function defaultWearer(): WearerAnswer {
  const { server } = useSession.getState();
  const measures = server?.wearers.measures.map(({ name, default: cm }) => [name, cm] as const) ?? [];
  return {
    body: server?.body ?? "",
    name: "",
    figure: null as Figure | null,
    given: {},
    mesh: null,
    stands_in: false,
    measures: Object.fromEntries(measures),
  };
}
