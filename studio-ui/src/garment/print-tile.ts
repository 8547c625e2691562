/** Prints that garments have of themselves: one repeat of each, drawn by the server as in its previews. */

import { LinearMipmapLinearFilter, RepeatWrapping, SRGBColorSpace, Texture } from "three";
import { api } from "../api/client";
import type { ClothPrint } from "../api/types";

export interface PrintTile {
  print: ClothPrint;
  image: ImageBitmap;
  /** Row by row, from places on the cloth, cm, to repeats. */
  matrix: readonly [number, number, number, number];
}

/** Prints that go through to the wrong side of the cloth. */
const WOVEN: readonly ClothPrint["kind"][] = ["stripes", "checks", "plaid"];
/** The attribute of geometries that holds places on the cloth: uv1. */
const ON_CLOTH = 1;
const KEPT = 24;
const asked = new Map<string, Promise<PrintTile>>();
const loaded = new Map<string, PrintTile>();

export const isWoven = ({ kind }: ClothPrint): boolean => WOVEN.includes(kind);

/** A print as the server's address for it has it; the same for the same prints, and only for these. */
export function tileQuery({ kind, colors, motif, sizes = {} }: ClothPrint): URLSearchParams {
  const query = new URLSearchParams({ kind });
  for (const color of colors) query.append("colors", color);
  if (kind === "motif" && motif !== undefined) query.set("motif", motif);
  for (const [name, size] of Object.entries(sizes).sort()) query.set(name, String(size));
  return query;
}

export function samePrint(a: ClothPrint | null | undefined, b: ClothPrint | null | undefined): boolean {
  return a === b || (a ? tileQuery(a).toString() : "") === (b ? tileQuery(b).toString() : "");
}

/** The tile of a print, fetched once. */
export function printTile(print: ClothPrint): Promise<PrintTile> {
  const query = tileQuery(print);
  const key = query.toString();
  const known = asked.get(key);
  if (known !== undefined) return known;
  const tile = fetched(print, query);
  asked.set(key, tile);
  tile.then(
    (found) => loaded.set(key, found),
    () => asked.delete(key),
  );
  for (const oldest of asked.keys()) {
    if (asked.size <= KEPT) break;
    asked.delete(oldest);
    loaded.delete(oldest);
  }
  return tile;
}

/** The tile of a print where it is there already. */
export function loadedTile(print: ClothPrint): PrintTile | null {
  return loaded.get(tileQuery(print).toString()) ?? null;
}

async function fetched(print: ClothPrint, query: URLSearchParams): Promise<PrintTile> {
  const { picture, matrix } = await api.tile(query);
  if (matrix.length !== 4 || !matrix.every(Number.isFinite))
    throw new Error("The server's print does not say how large it is.");
  // Textures begin at the bottom, pictures at the top.
  const image = await createImageBitmap(picture, { imageOrientation: "flipY", colorSpaceConversion: "none" });
  return { print, image, matrix: matrix as [number, number, number, number] };
}

/** Repeated over the cloth at true size. */
export function tileTexture({ image, matrix: [a, b, c, d] }: PrintTile, anisotropy: number): Texture {
  const texture = new Texture(image);
  texture.flipY = false;
  texture.channel = ON_CLOTH;
  texture.wrapS = RepeatWrapping;
  texture.wrapT = RepeatWrapping;
  texture.minFilter = LinearMipmapLinearFilter;
  texture.matrixAutoUpdate = false;
  texture.matrix.set(a, b, 0, c, d, 0, 0, 0, 1);
  texture.colorSpace = SRGBColorSpace;
  texture.anisotropy = anisotropy;
  texture.needsUpdate = true;
  return texture;
}
