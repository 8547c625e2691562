import { Box3 } from "three";
import type { GarmentViewer } from "../garment/viewer";

export interface CameraLink {
  /** Returns how to take it out again. */
  add: (viewer: GarmentViewer) => () => void;
  /** Brings this one's garment into view, and keeps those in it that were framed before. */
  frame: (viewer: GarmentViewer) => void;
}

/** Viewers that are turned together. */
export function cameraLink(): CameraLink {
  const viewers = new Set<GarmentViewer>();
  const all = new Box3();
  let following = false;
  const frame = (viewer: GarmentViewer) => viewer.stage.frame(all.union(viewer.bounds()), false);
  const add = (viewer: GarmentViewer) => {
    const follow = () => {
      if (following) return;
      following = true;
      for (const other of viewers) {
        if (other === viewer) continue;
        other.stage.camera.position.copy(viewer.stage.camera.position);
        other.stage.controls.target.copy(viewer.stage.controls.target);
        other.stage.controls.update();
        other.stage.invalidate();
      }
      following = false;
    };
    viewers.add(viewer);
    viewer.stage.controls.addEventListener("change", follow);
    return () => {
      viewers.delete(viewer);
      viewer.stage.controls.removeEventListener("change", follow);
    };
  };
  return { add, frame };
}
