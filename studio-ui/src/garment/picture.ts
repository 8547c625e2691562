/** A small picture of a garment from the front, drawn out of sight. */

import type { Document } from "../api/types";
import { bodyMesh } from "./mesh-cache";
import type { MeshData } from "./mesh-file";
import { ownLook } from "./own-look";
import { GarmentViewer } from "./viewer";

const WIDTH = 260;
const HEIGHT = 340;

let queue: Promise<unknown> = Promise.resolve();

/** A data URL. One after the other: a browser has few contexts to draw with. */
export function renderedPicture(
  mesh: MeshData,
  body: string,
  cloth: Pick<Document, "color" | "looks" | "print">,
): Promise<string> {
  const picture = queue.then(async () => {
    const [wearer, look] = await Promise.all([bodyMesh(body), ownLook(cloth)]);
    const box = document.createElement("div");
    box.style.cssText = `position: fixed; left: -9999px; width: ${WIDTH}px; height: ${HEIGHT}px`;
    document.body.append(box);
    const viewer = new GarmentViewer(box);
    try {
      viewer.showBody(wearer);
      viewer.setLook(look);
      viewer.setSeamsVisible(false);
      viewer.showGarment(mesh, []);
      viewer.frameAll(false);
      return viewer.stage.picture();
    } finally {
      viewer.dispose();
      box.remove();
    }
  });
  queue = picture.catch(() => {});
  return picture;
}
