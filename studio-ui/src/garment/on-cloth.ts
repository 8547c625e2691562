/** Where vertices were cut from the cloth, so that its print meets at seams as in the server's previews. */

const UNTURNED = [1, 0, 0, 0, 1, 0] as const;

/**
 * Places on the cloth, cm, of panel-local ones, by the matrix of each one's panel (`on_cloth` of mesh files); without
 * matrices, as in meshes of earlier versions, the same places.
 */
export function onCloth(uv: Float32Array, panel: Uint32Array, matrices: readonly number[][]): Float32Array {
  const found = new Float32Array(uv.length);
  for (let k = 0; 2 * k < uv.length; k += 1) {
    const [a, b, c, d, e, f] = (matrices[panel[k] ?? -1] ?? UNTURNED) as typeof UNTURNED;
    const [u, v] = [uv[2 * k] as number, uv[2 * k + 1] as number];
    found[2 * k] = a * u + b * v + c;
    found[2 * k + 1] = d * u + e * v + f;
  }
  return found;
}
