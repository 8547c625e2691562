/** Keeps one viewer in step with the store. */

import { type RefObject, useEffect, useState } from "react";
import { tellFailure } from "../actions/failures";
import { sewAgain } from "../actions/live";
import { bodyOf, wearerKey } from "../actions/wearers";
import { ApiError } from "../api/client";
import type { ClothPrint } from "../api/types";
import { useDisplay } from "../state/display";
import type { Version } from "../state/document";
import { seamColor } from "../state/seam-colors";
import { useSession } from "../state/session";
import { currentVersion, shownMesh, shownPattern, useStudio } from "../state/store";
import { PLAIN_LOOK } from "./cloth";
import { DEFAULT_CLOTH } from "./cloth-color";
import { garmentMesh } from "./mesh-cache";
import type { MeshData } from "./mesh-file";
import { loadedTile, printTile, samePrint } from "./print-tile";
import { GarmentViewer } from "./viewer";

export function useGarmentViewer(box: RefObject<HTMLDivElement | null>): GarmentViewer | null {
  const [viewer, setViewer] = useState<GarmentViewer | null>(null);
  const [failed, setFailed] = useState<unknown>(null);
  useEffect(() => {
    if (box.current === null) return;
    let made: GarmentViewer;
    try {
      made = new GarmentViewer(box.current);
    } catch (error) {
      setFailed(error);
      return;
    }
    setViewer(made);
    const ends = [
      followMesh(made),
      followBody(made),
      followFrames(made),
      followLook(made),
      followMarks(made),
    ];
    return () => {
      for (const end of ends) end();
      made.dispose();
      setViewer(null);
    };
  }, [box]);
  if (failed !== null) throw failed;
  return viewer;
}

/** Colours of the mesh's seams, by their place among the pattern's stitches: the same in both windows. */
function seamColors(data: MeshData): string[] {
  const { theme } = useStudio.getState();
  const stitches = shownPattern(useStudio.getState())?.pattern.stitches ?? [];
  const byPlace = new Map(
    stitches.flatMap((stitch, k) => stitch.slice(0, 2).map((side) => [placeKey(side), k])),
  );
  return data.seams.map(({ first }) => seamColor(byPlace.get(placeKey(first)) ?? 0, theme));
}

const placeKey = (side: unknown): string => {
  const { panel, edge } = side as { panel: string; edge: number };
  return `${edge} ${panel}`;
};

function followMesh(viewer: GarmentViewer): () => void {
  let wanted: string | null = null;
  let document: number | undefined;
  let reframe = false;
  const update = () => {
    const state = useStudio.getState();
    const name = shownMesh(state);
    if (currentVersion(state) === null) viewer.showGarment(null, []);
    const opened = state.history?.entries[0]?.id;
    if (name === null && opened !== document) {
      // What was opened cannot be sewn (yet): the garment of what was open before is not its own.
      viewer.showGarment(null, []);
      viewer.stage.unmark("mesh");
      document = opened;
      wanted = null;
      reframe = true;
    }
    if (name === null || name === wanted) return;
    wanted = name;
    garmentMesh(name).then(
      (data) => {
        // A newer one may have been asked for meanwhile; it comes by itself.
        if (wanted !== name) return;
        viewer.showGarment(data, seamColors(data));
        viewer.stage.mark("mesh", name);
        // Only another document moves the camera.
        const first = useStudio.getState().history?.entries[0]?.id;
        if (first !== document || reframe) viewer.frameAll(document !== undefined);
        document = first;
        reframe = false;
      },
      (error) => {
        if (wanted !== name) return;
        wanted = null;
        if (error instanceof ApiError && error.status === 404) sewAgain();
        else tellFailure(error);
      },
    );
  };
  update();
  const end = useStudio.subscribe(update);
  const endSession = useSession.subscribe((state, before) => {
    // After live frames what the history shows comes back, also where the work was cancelled.
    if (state.frame !== null || before.frame === null || wanted === null) return;
    const name = wanted;
    setTimeout(() => {
      // What was finished is another garment, and shown by now.
      if (wanted !== name || useSession.getState().frame !== null) return;
      void garmentMesh(name).then((data) => {
        if (wanted !== name) return;
        viewer.showGarment(data, seamColors(data));
      });
    }, 300);
  });
  return () => {
    end();
    endSession();
  };
}

function followBody(viewer: GarmentViewer): () => void {
  let shown: string | null = null;
  const update = () => {
    const pattern = currentVersion(useStudio.getState())?.pattern ?? null;
    if (useSession.getState().server === null) return;
    const name = wearerKey(pattern);
    if (name === shown) return;
    shown = name;
    // The one before would stick out of what is made for another.
    viewer.showBody(null);
    viewer.stage.unmark("wearer");
    bodyOf(pattern).then((data) => {
      if (shown !== name) return;
      viewer.showBody(data);
      viewer.setBodyVisible(useDisplay.getState().body);
      viewer.stage.mark("wearer", name);
      if (viewer.data === null) viewer.frameAll(false);
    }, tellFailure);
  };
  update();
  const ends = [useStudio.subscribe(update), useSession.subscribe(update)];
  return () => {
    for (const end of ends) end();
  };
}

function followFrames(viewer: GarmentViewer): () => void {
  return useSession.subscribe((state, before) => {
    const { frame } = state;
    if (frame === null || frame === before.frame) return;
    void garmentMesh(frame.mesh).then((data) => {
      if (useSession.getState().frame !== frame) return;
      if (viewer.data !== data) viewer.showGarment(data, seamColors(data));
      viewer.showFrame(frame.positions);
      viewer.stage.mark("frame", String(frame.number));
    });
  });
}

function followLook(viewer: GarmentViewer): () => void {
  let awaited: ClothPrint | null = null;
  const update = () => {
    const { coloring, trialPrint, body, wireframe, normals, seams } = useDisplay.getState();
    const version = currentVersion(useStudio.getState());
    const color = version?.color ?? DEFAULT_CLOTH;
    const panels = version?.looks?.panels ?? PLAIN_LOOK.panels;
    const own = trialPrint === null ? (version?.print ?? null) : null;
    const tile = own === null ? null : loadedTile(own);
    const print = trialPrint ?? "plain";
    viewer.setLook({ coloring, print, tile, color, panels, wireframe, normals });
    if (own !== null && tile === null && own !== awaited) {
      awaited = own;
      printTile(own)
        .then(update, tellFailure)
        .finally(() => {
          awaited = null;
        });
    }
    viewer.setBodyVisible(body);
    viewer.setSeamsVisible(seams);
  };
  update();
  let shown: Version | null = null;
  const ends = [
    useDisplay.subscribe(update),
    useStudio.subscribe((state) => {
      const now = currentVersion(state);
      const before = shown;
      shown = now;
      const printed = !samePrint(now?.print, before?.print);
      // A print that was asked for is shown, whatever was looked at before.
      if (printed && before !== null && now?.print) useDisplay.getState().change({ trialPrint: null });
      if (printed || now?.color !== before?.color || now?.looks !== before?.looks) update();
    }),
  ];
  return () => {
    for (const end of ends) end();
  };
}

function followMarks(viewer: GarmentViewer): () => void {
  const update = () => {
    const { selection, hover, theme } = useStudio.getState();
    const [selectColor, hoverColor] = theme === "dark" ? ["#ff9a5a", "#7ab8ff"] : ["#c2410c", "#0b63ce"];
    viewer.setMarks({ selected: selection, hover, selectColor, hoverColor }, (stitch) => {
      const found = shownPattern(useStudio.getState())?.pattern.stitches[stitch];
      return found === undefined ? null : [found[0], found[1]];
    });
  };
  update();
  return useStudio.subscribe((state, before) => {
    if (state.selection !== before.selection || state.hover !== before.hover || state.theme !== before.theme)
      update();
    if (state.theme !== before.theme && viewer.data !== null)
      viewer.showGarment(viewer.data, seamColors(viewer.data));
  });
}
