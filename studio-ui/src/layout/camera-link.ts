import type { GarmentViewer } from "../garment/viewer";

/** Viewers that are turned together: returns how to add one, which returns how to take it out again. */
export function cameraLink(): (viewer: GarmentViewer) => () => void {
  const viewers = new Set<GarmentViewer>();
  let following = false;
  return (viewer) => {
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
}
