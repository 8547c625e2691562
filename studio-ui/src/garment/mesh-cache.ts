/** Meshes by name, fetched once each. Names are digests of their content, so that none can be stale. */

import { api } from "../api/client";
import { type MeshData, readMeshFile } from "./mesh-file";

const KEPT = 24;
const garments = new Map<string, Promise<MeshData>>();
const bodies = new Map<string, Promise<MeshData>>();

export function garmentMesh(name: string): Promise<MeshData> {
  return fetched(garments, name, api.mesh);
}

export function bodyMesh(name: string): Promise<MeshData> {
  return fetched(bodies, name, api.body);
}

function fetched(
  cache: Map<string, Promise<MeshData>>,
  name: string,
  fetchBytes: (name: string) => Promise<ArrayBuffer>,
): Promise<MeshData> {
  const known = cache.get(name);
  if (known !== undefined) {
    cache.delete(name);
    cache.set(name, known);
    return known;
  }
  const mesh = fetchBytes(name).then(readMeshFile);
  cache.set(name, mesh);
  mesh.catch(() => cache.delete(name));
  for (const oldest of cache.keys()) {
    if (cache.size <= KEPT) break;
    cache.delete(oldest);
  }
  return mesh;
}
