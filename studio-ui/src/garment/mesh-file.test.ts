import { describe, expect, it } from "vitest";
import type { MeshHeader } from "../api/types";
import { computeNormals, type MeshData, readMeshFile, spreadFrame } from "./mesh-file";

/** Two triangles that share an edge by a seam: a square in the plane z = 0, six split vertices, four welded. */
const POSITIONS = [0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 0, 0, 1, 1, 0, 0, 1, 0];
const WELD = [0, 1, 2, 0, 2, 3];

function file(change: Partial<MeshHeader> = {}, magic = "STMESH01"): ArrayBuffer {
  const arrays: [string, "f32" | "u32", number[]][] = [
    ["positions", "f32", POSITIONS],
    ["normals", "f32", POSITIONS.map((_, k) => (k % 3 === 2 ? 1 : 0))],
    ["uv", "f32", [0, 0, 1, 0, 1, 1, 0, 0, 1, 1, 0, 1]],
    ["panel", "u32", [0, 0, 0, 1, 1, 1]],
    ["weld", "u32", WELD],
    ["triangles", "u32", [0, 1, 2, 3, 4, 5]],
    ["edge_vertices", "u32", [0, 1]],
    ["edge_offsets", "u32", [0, 2]],
    ["trim_positions", "f32", [0, 0, 1, 1, 0, 1, 0, 1, 1, 5, 5, 5, 6, 5, 5, 5, 6, 5]],
    ["trim_uv", "f32", [0, 0, 1, 0, 0, 1, 0, 0, 0, 0, 0, 0]],
    ["trim_panel", "u32", [1, 1, 1, 0, 0, 0]],
    ["trim_triangles", "u32", [0, 1, 2, 0, 2, 1]],
    ["trim_lines", "u32", [0, 1, 1, 2]],
  ];
  let offset = 0;
  const blocks = arrays.map(([name, type, values]) => {
    const block = { name, type, count: values.length, offset };
    offset += 4 * values.length;
    return block;
  });
  const header: MeshHeader = {
    version: 1,
    kind: "garment",
    vertices: 6,
    triangles: 2,
    welded: 4,
    panels: ["left", "right"],
    seams: [{ first: { panel: "left", edge: 2 }, second: { panel: "right", edge: 0 } }],
    edges: [{ panel: "left", edge: 0 }],
    color: "#ff0000",
    blocks,
    ...change,
  };
  let text = JSON.stringify(header);
  text += " ".repeat((4 - ((12 + text.length) % 4)) % 4);
  const buffer = new ArrayBuffer(12 + text.length + offset);
  new Uint8Array(buffer).set(new TextEncoder().encode(magic), 0);
  new DataView(buffer).setUint32(8, text.length, true);
  new Uint8Array(buffer).set(new TextEncoder().encode(text), 12);
  arrays.forEach(([, type, values], k) => {
    const at = 12 + text.length + (blocks[k]?.offset ?? 0);
    (type === "f32"
      ? new Float32Array(buffer, at, values.length)
      : new Uint32Array(buffer, at, values.length)
    ).set(values);
  });
  return buffer;
}

describe("mesh files", () => {
  it("are read as they were written", () => {
    const mesh = readMeshFile(file());
    expect([...mesh.positions]).toEqual(POSITIONS);
    expect([...mesh.triangles]).toEqual([0, 1, 2, 3, 4, 5]);
    expect(mesh.panels).toEqual(["left", "right"]);
    expect(mesh.seams[0]?.second).toEqual({ panel: "right", edge: 0 });
    expect([...mesh.edgeVertices]).toEqual([0, 1]);
    expect(mesh.strain).toHaveLength(0);
    expect(mesh.color).toBe("#ff0000");
  });

  it("are refused with a reason", () => {
    expect(() => readMeshFile(file({}, "GLTFxxxx"))).toThrow('begins with "GLTFxxxx"');
    expect(() => readMeshFile(new ArrayBuffer(3))).toThrow("no mesh file");
    expect(() => readMeshFile(file().slice(0, 60))).toThrow("ends within its header");
    expect(() => readMeshFile(file({ version: 2 as 1 }))).toThrow("version 2");
    expect(() => readMeshFile(file({ vertices: 7 }))).toThrow("fewer vertices");
  });

  it("carry pockets and the like, each with its own vertices", () => {
    expect(readMeshFile(file()).trims).toEqual([]);
    const counts = { vertices: 3, triangles: 1 };
    const trims: MeshHeader["trims"] = [
      { name: "patch pockets (cloth)", look: "cloth", on_panel: true, ...counts, lines: 2 },
      { name: "buckle belt (metal)", look: "metal", on_panel: false, ...counts, lines: 0 },
    ];
    const moved = [
      [1, 0, 0, 0, 1, 0],
      [0, 1, 7, -1, 0, 9],
    ];
    const mesh = readMeshFile(file({ trims, on_cloth: moved }));
    const [pocket, buckle] = mesh.trims;
    expect([...mesh.cloth]).toEqual([0, 0, 1, 0, 1, 1, 7, 9, 8, 8, 8, 9]);
    expect([...(pocket?.cloth ?? [])]).toEqual([7, 9, 7, 8, 8, 9]);
    expect(buckle?.cloth).toBeNull();
    expect(pocket?.look).toBe("cloth");
    expect([...(pocket?.uv ?? [])]).toEqual([0, 0, 1, 0, 0, 1]);
    expect([...(pocket?.lines ?? [])]).toEqual([0, 1, 1, 2]);
    expect(buckle?.uv).toBeNull();
    expect([...(buckle?.positions ?? [])]).toEqual([5, 5, 5, 6, 5, 5, 5, 6, 5]);
    expect([...(buckle?.triangles ?? [])]).toEqual([0, 2, 1]);
    expect(buckle?.lines).toHaveLength(0);
    const more = trims.map((trim) => ({ ...trim, vertices: 4 }));
    expect(() => readMeshFile(file({ trims: more }))).toThrow('"buckle belt (metal)"');
  });

  it("move by frames of the welded vertices, with normals smooth across seams", () => {
    const mesh: MeshData = readMeshFile(file());
    const frame = new Float32Array([0, 0, 0, 1, 0, 0, 1, 1, 1, 0, 1, 0]);
    const positions = new Float32Array(18);
    spreadFrame(mesh, frame, positions);
    expect([...positions.subarray(6, 9)]).toEqual([1, 1, 1]);
    expect([...positions.subarray(12, 15)]).toEqual([1, 1, 1]);
    const normals = new Float32Array(18);
    computeNormals(mesh, positions, normals);
    for (let v = 0; v < 6; v += 1) {
      const [x, y, z] = normals.subarray(3 * v, 3 * v + 3);
      expect(Math.hypot(x ?? 0, y ?? 0, z ?? 0)).toBeCloseTo(1, 5);
    }
    // Both copies of the seam's corners have the same normal, between those of the two triangles.
    expect([...normals.subarray(0, 3)]).toEqual([...normals.subarray(9, 12)]);
    expect(normals[0]).toBeCloseTo(normals[1] ?? 0, 5);
  });
});
