# ruff: noqa: E402, T201
"""Writes a small GarmentCodeData with GarmentCode's own code; run by test_garmentcode_checkout.py.

Sampling, pattern files, box meshes, their serialization and the compaction are GarmentCode's. The simulator
is not needed: the box mesh is moved as a whole, and stored by the function that stores a simulated frame.

Usage: python write_garmentcodedata.py CHECKOUT OUT COUNT SEED
"""

from __future__ import annotations

import json
import random
import shutil
import sys
from pathlib import Path
from types import SimpleNamespace
from unittest.mock import MagicMock

import yaml

CHECKOUT, OUT = Path(sys.argv[1]).resolve(), Path(sys.argv[2]).resolve()
COUNT, SEED = int(sys.argv[3]), int(sys.argv[4])
sys.path.insert(0, str(CHECKOUT))
for name in (
    "warp",
    "warp.sim",
    "warp.sim.render",
    "warp.sim.utils",
    "warp.sim.collide",
    "warp.sim.integrator_xpbd",
    "warp.collision",
    "warp.collision.panel_assignment",
    "pyrender",
):
    sys.modules[name] = MagicMock()  # the simulator and the renderer, of which nothing is called

import pattern_sampler
import pygarment as pyg
from assets.bodies.body_params import BodyParameters
from assets.garment_programs.meta_garment import MetaGarment
from pygarment.data_config import Properties
from pygarment.meshgen.boxmeshgen import BoxMesh
from pygarment.meshgen.garment import Cloth
from pygarment.meshgen.sim_config import PathCofig
from pygarment.meshgen.simulation import optimize_garment_storage

UP_CM = 7.5


def main() -> None:
    bodies = CHECKOUT / "assets" / "bodies"
    Path("system.json").write_text(json.dumps({"bodies_default_path": str(bodies)}))
    random.seed(SEED)
    body = BodyParameters(bodies / "mean_all.yaml")
    sampler = pyg.DesignSampler(str(CHECKOUT / "assets" / "design_params" / "default.yaml"))
    batch = OUT / "garments_5000_0"
    made: list[str] = []
    while len(made) < COUNT:
        design = sampler.randomize()
        name = f"rand_{pattern_sampler._id_generator()}"
        body.params["body_sample"] = "mean_all_apart" if pattern_sampler.has_pants(design) else "mean_all"
        try:
            pattern_sampler.assert_param_combinations(design)
            piece = MetaGarment(name, body, design)
            piece.assert_total_length()
            if piece.is_self_intersecting():
                continue
            pattern_sampler._save_sample(piece, body, design, OUT / "data")
            simulate(OUT / "data" / name, batch / "default_body", name)
        except KeyboardInterrupt:
            raise
        except BaseException as error:  # GarmentCode's own errors are no `Exception`
            print(name, type(error).__name__, error)
            shutil.rmtree(batch / "default_body" / name, ignore_errors=True)
            continue
        made.append(name)
    props = Properties()
    props.set_basic(name="garments_5000_0", size=COUNT)
    props.set_section_config("sim")
    props.set_section_stats("sim", fails={"static_equilibrium": made[-1:], "crashes": []}, sim_time={})
    props.serialize(batch / "dataset_properties_default_body.yaml")
    shutil.rmtree(OUT / "data")


def simulate(source: Path, out: Path, name: str) -> None:
    """What `run_simulation` of pattern_data_sim.py leaves behind, without its steps."""
    out.mkdir(parents=True, exist_ok=True)
    paths = PathCofig(in_element_path=source, out_path=out, in_name=name, body_name="mean_all")
    mesh = BoxMesh(paths.in_g_spec, 1.0)
    mesh.load()
    mesh.serialize(paths, store_panels=False, uv_config={"dpi": 60})
    moved = [[x, y + UP_CM, z] for x, y, z in mesh.vertices]
    Cloth.save_frame(SimpleNamespace(paths=paths, current_verts=moved))
    optimize_garment_storage(paths)
    paths.element_sim_props.write_text(yaml.dump({"sim": {"config": {}}}))


if __name__ == "__main__":
    main()
