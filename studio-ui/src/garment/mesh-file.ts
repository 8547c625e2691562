/** Reads the studio's binary mesh files (API.md, "Mesh files") without copying their data. */

import type { EdgePlace, MeshHeader, MeshSeam, TrimLook } from "../api/types";
import { onCloth } from "./on-cloth";

const MAGIC = "STMESH01";

/** A mesh as the viewer draws it: n vertices, each of one panel, and t triangles. Lengths in cm, Y up. */
export interface MeshData {
  vertices: number;
  triangles: Uint32Array;
  positions: Float32Array;
  normals: Float32Array;
  /** Panel-local cm, the same as the pattern's vertices; empty for bodies. */
  uv: Float32Array;
  /** Where on the cloth the vertices were cut, cm: for prints that meet at seams. */
  cloth: Float32Array;
  /** Index into `panels` per vertex; empty for bodies. */
  panel: Uint32Array;
  panels: string[];
  /** Vertex after seams are closed, per vertex. */
  weld: Uint32Array;
  welded: number;
  strain: Float32Array;
  seams: MeshSeam[];
  seamVertices: Uint32Array;
  seamOffsets: Uint32Array;
  edges: EdgePlace[];
  edgeVertices: Uint32Array;
  edgeOffsets: Uint32Array;
  /** 0 to 1 per vertex, for bodies; empty otherwise. */
  colors: Float32Array;
  /** "#rrggbb" of the cloth, or null. */
  color: string | null;
  trims: TrimData[];
}

/** Pockets, buttons or the like of one look: positions in cm, indices into them. */
export interface TrimData {
  look: TrimLook;
  /** "#rrggbb" where it is its own. */
  color: string | null;
  positions: Float32Array;
  /** Panel-local cm, for prints; null of what goes around the body. */
  uv: Float32Array | null;
  /** Where on the cloth they were cut, cm; goes with `uv`. */
  cloth: Float32Array | null;
  triangles: Uint32Array;
  /** Pairs of vertices: edges that show. */
  lines: Uint32Array;
}

/** Throws an Error that says what is wrong with the file. */
export function readMeshFile(buffer: ArrayBuffer): MeshData {
  const magic = new TextDecoder("latin1").decode(new Uint8Array(buffer, 0, Math.min(8, buffer.byteLength)));
  if (magic !== MAGIC) throw new Error(`This is no mesh file: it begins with "${magic}" and not "${MAGIC}".`);
  const length = new DataView(buffer).getUint32(8, true);
  const start = 12 + length;
  if (start > buffer.byteLength) throw new Error("The mesh file ends within its header.");
  const header = JSON.parse(new TextDecoder().decode(new Uint8Array(buffer, 12, length))) as MeshHeader;
  if (header.version !== 1) throw new Error(`Mesh files of version ${header.version} are not known, only 1.`);

  const floats = (name: string): Float32Array => {
    const block = header.blocks.find((each) => each.name === name && each.type === "f32");
    return block ? new Float32Array(buffer, start + block.offset, block.count) : new Float32Array(0);
  };
  const integers = (name: string): Uint32Array => {
    const block = header.blocks.find((each) => each.name === name && each.type === "u32");
    return block ? new Uint32Array(buffer, start + block.offset, block.count) : new Uint32Array(0);
  };
  const mesh: MeshData = {
    vertices: header.vertices,
    triangles: integers("triangles"),
    positions: floats("positions"),
    normals: floats("normals"),
    uv: floats("uv"),
    cloth: onCloth(floats("uv"), integers("panel"), header.on_cloth ?? []),
    panel: integers("panel"),
    panels: header.panels,
    weld: integers("weld"),
    welded: header.welded,
    strain: floats("strain"),
    seams: header.seams,
    seamVertices: integers("seam_vertices"),
    seamOffsets: integers("seam_offsets"),
    edges: header.edges,
    edgeVertices: integers("edge_vertices"),
    edgeOffsets: integers("edge_offsets"),
    colors: floats("color"),
    color: header.color,
    trims: readTrims(header, floats, integers),
  };
  if (mesh.positions.length !== 3 * header.vertices || mesh.triangles.length !== 3 * header.triangles)
    throw new Error("The mesh file holds fewer vertices or triangles than its header says.");
  return mesh;
}

function readTrims(
  header: MeshHeader,
  floats: (name: string) => Float32Array,
  integers: (name: string) => Uint32Array,
): TrimData[] {
  const [positions, uv] = [floats("trim_positions"), floats("trim_uv")];
  const panel = integers("trim_panel");
  const cloth = onCloth(uv, panel, header.on_cloth ?? []);
  const [triangles, lines] = [integers("trim_triangles"), integers("trim_lines")];
  const from = { vertices: 0, triangles: 0, lines: 0 };
  return (header.trims ?? []).map((trim) => {
    const [vertex, triangle, line] = [from.vertices, from.triangles, from.lines];
    from.vertices += trim.vertices;
    from.triangles += trim.triangles;
    from.lines += trim.lines;
    const own = {
      look: trim.look,
      color: trim.color ?? null,
      positions: positions.subarray(3 * vertex, 3 * from.vertices),
      uv: trim.on_panel ? uv.subarray(2 * vertex, 2 * from.vertices) : null,
      cloth: trim.on_panel ? cloth.subarray(2 * vertex, 2 * from.vertices) : null,
      triangles: triangles.subarray(3 * triangle, 3 * from.triangles),
      lines: lines.subarray(2 * line, 2 * from.lines),
    };
    if (own.positions.length !== 3 * trim.vertices || own.triangles.length !== 3 * trim.triangles)
      throw new Error(
        `The mesh file holds fewer vertices or triangles of "${trim.name}" than its header says.`,
      );
    return own;
  });
}

/** Smooth normals of the split vertices, over the welded ones: (n, 3) into `normals`. */
export function computeNormals(mesh: MeshData, positions: Float32Array, normals: Float32Array): void {
  const { triangles, weld, welded, vertices } = mesh;
  const sums = new Float32Array(3 * welded);
  for (let t = 0; t < triangles.length; t += 3) {
    const [i, j, k] = [triangles[t] as number, triangles[t + 1] as number, triangles[t + 2] as number];
    const ax = at(positions, j, 0) - at(positions, i, 0);
    const ay = at(positions, j, 1) - at(positions, i, 1);
    const az = at(positions, j, 2) - at(positions, i, 2);
    const bx = at(positions, k, 0) - at(positions, i, 0);
    const by = at(positions, k, 1) - at(positions, i, 1);
    const bz = at(positions, k, 2) - at(positions, i, 2);
    const nx = ay * bz - az * by;
    const ny = az * bx - ax * bz;
    const nz = ax * by - ay * bx;
    for (const v of [i, j, k]) {
      const w = 3 * (weld[v] as number);
      sums[w] = (sums[w] as number) + nx;
      sums[w + 1] = (sums[w + 1] as number) + ny;
      sums[w + 2] = (sums[w + 2] as number) + nz;
    }
  }
  for (let v = 0; v < vertices; v += 1) {
    const w = 3 * (weld[v] as number);
    const [x, y, z] = [sums[w] as number, sums[w + 1] as number, sums[w + 2] as number];
    const length = Math.hypot(x, y, z) || 1;
    normals[3 * v] = x / length;
    normals[3 * v + 1] = y / length;
    normals[3 * v + 2] = z / length;
  }
}

/** Positions of the split vertices from a frame of the welded ones. */
export function spreadFrame(mesh: MeshData, frame: Float32Array, positions: Float32Array): void {
  for (let v = 0; v < mesh.vertices; v += 1) {
    const w = 3 * (mesh.weld[v] as number);
    positions[3 * v] = frame[w] as number;
    positions[3 * v + 1] = frame[w + 1] as number;
    positions[3 * v + 2] = frame[w + 2] as number;
  }
}

function at(array: Float32Array, vertex: number, axis: number): number {
  return array[3 * vertex + axis] as number;
}
