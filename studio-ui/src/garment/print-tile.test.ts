import { describe, expect, it } from "vitest";
import type { ClothPrint } from "../api/types";
import { onCloth } from "./on-cloth";
import { isWoven, samePrint, tileQuery, tileTexture } from "./print-tile";

const DOTS: ClothPrint = { kind: "dots", colors: ["#203050", "#ffffff"], sizes: { spacing: 4, radius: 0.8 } };

describe("prints", () => {
  it("are asked for by an address of their own", () => {
    expect(tileQuery(DOTS).toString()).toBe(
      "kind=dots&colors=%23203050&colors=%23ffffff&radius=0.8&spacing=4",
    );
    const flowers: ClothPrint = { kind: "motif", colors: ["#000000", "#ffffff"], motif: "flowers" };
    expect(tileQuery(flowers).get("motif")).toBe("flowers");
  });

  it("are the same whatever the order of their sizes", () => {
    expect(samePrint(DOTS, { ...DOTS, sizes: { radius: 0.8, spacing: 4 } })).toBe(true);
    expect(samePrint(DOTS, { ...DOTS, colors: ["#203051", "#ffffff"] })).toBe(false);
    expect(samePrint(null, undefined)).toBe(true);
    expect(samePrint(DOTS, null)).toBe(false);
  });

  it("are seen on both sides of the cloth where they are woven", () => {
    expect(isWoven({ ...DOTS, kind: "plaid" })).toBe(true);
    expect(isWoven(DOTS)).toBe(false);
  });

  it("are laid on the cloth by the matrix of their tile", () => {
    const texture = tileTexture({ print: DOTS, image: {} as ImageBitmap, matrix: [0.25, 0, 0.1, 0.5] }, 4);
    expect(texture.channel).toBe(1);
    // Column by column: x, y to x / 4, x / 10 + y / 2.
    expect(texture.matrix.elements).toEqual([0.25, 0.1, 0, 0, 0.5, 0, 0, 0, 1]);
  });
});

describe("places on the cloth", () => {
  const uv = new Float32Array([1, 2, 3, 4]);

  it("are turned, mirrored and moved as each panel is", () => {
    const matrices = [
      [0, -1, 10, 1, 0, 20],
      [-1, 0, 5, 0, 1, 0],
    ];
    expect([...onCloth(uv, new Uint32Array([0, 1]), matrices)]).toEqual([8, 21, 2, 4]);
  });

  it("are those on the panel in meshes that do not say", () => {
    expect([...onCloth(uv, new Uint32Array(0), [])]).toEqual([1, 2, 3, 4]);
  });
});
