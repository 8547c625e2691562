/** Property tests take the same examples each time, so that a run that fails can be repeated; $FC_SEED: others. */

import fc from "fast-check";

fc.configureGlobal({ seed: Number(process.env.FC_SEED ?? 20261124) });
