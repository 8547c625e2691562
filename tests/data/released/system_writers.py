"""Writes folders of outputs as released systems do: names, nesting and content after each one's own code.

Each writer takes patterns by the name of the input and gives back the ids that a reader should find.
"""

from __future__ import annotations

import json
import pickle
from collections.abc import Mapping
from dataclasses import replace
from pathlib import Path

import numpy as np
from old_style import old_style

from swifttailor.pattern import Arc, Cubic, Pattern, Quadratic, to_specification
from swifttailor.pattern.curve import Curve, evaluate, to_relative
from swifttailor.pattern.panel import Edge

PROPERTIES = {
    "curvature_coords": "relative",
    "normalize_panel_translation": False,
    "normalized_edge_loops": True,
    "units_in_meter": 100,
}
PNG = b"\x89PNG\r\n\x1a\n"
STAMP = "241124-18-30-05"
DANGLING_EVERY = 4
"""One in so many patterns has a panel whose last edge does not come back to its start."""


class Mark:
    """Leaves a file behind when somebody unpickles it."""

    def __init__(self, path: Path) -> None:
        self.path = str(path)

    def __reduce__(self):
        return open, (self.path, "w")


def write_pickle(path: Path) -> None:
    path.write_bytes(pickle.dumps(Mark(path.with_name("unpickled"))))


# What the networks of this family write: extrinsic angles, loops from the origin


def predicted(
    pattern: Pattern,
    *,
    quadratic_only: bool = False,
    names: Mapping[str, str] | None = None,
    dangling: bool = False,
) -> dict:
    """The pattern as `NNSewingPattern` holds it.

    Args:
        pattern: Placed in this package's way.
        quadratic_only: Whether a curve is one control point, given as a bare list, as before GarmentCode.
        names: Other names for panels.
        dangling: Whether the first panel's last edge misses the start, so that a vertex is added.
    """
    called = {p.name: (names or {}).get(p.name, p.name) for p in pattern.panels}
    panels = {}
    for number, panel in enumerate(pattern.panels):
        origin = panel.vertices[0]
        vertices = (panel.vertices - origin).tolist()
        count = len(vertices)
        edges = []
        for k, edge in enumerate(panel.edges):
            written: dict = {"endpoints": [k, (k + 1) % count]}
            curvature = _curvature(edge.curve, quadratic_only)
            if curvature is not None:
                written["curvature"] = curvature
            edges.append(written)
        if dangling and number == 0:
            vertices.append([vertices[0][0] + 3.5, vertices[0][1] + 1.0])
            edges[-1]["endpoints"] = [count - 1, count]
        placement = panel.placement.read_as("extrinsic")
        moved = np.asarray(placement.translation) + placement.matrix() @ [*origin, 0.0]
        panels[called[panel.name]] = {
            "translation": moved.tolist(),
            "rotation": list(placement.rotation),
            "vertices": vertices,
            "edges": edges,
        }
    stitches = [[{"panel": called[r.panel], "edge": r.edge} for r in s.sides] for s in pattern.stitches]
    inner = {"panels": panels, "stitches": stitches, "panel_order": list(panels)}
    return {"pattern": inner, "parameters": {}, "parameter_order": [], "properties": dict(PROPERTIES)}


def _curvature(curve: Curve, quadratic_only: bool):
    if isinstance(curve, Quadratic):
        return (
            list(curve.control) if quadratic_only else {"type": "quadratic", "params": [list(curve.control)]}
        )
    if isinstance(curve, Cubic):
        return {"type": "cubic", "params": [list(curve.control_1), list(curve.control_2)]}
    if isinstance(curve, Arc):
        return {"type": "circle", "params": [curve.radius, int(curve.large), int(curve.right)]}
    return None


def with_quadratics(pattern: Pattern) -> Pattern:
    """The nearest pattern of lines and quadratic curves."""
    panels = tuple(
        replace(p, edges=tuple(Edge(_quadratic(e.curve, p.chord(k)), e.label) for k, e in enumerate(p.edges)))
        for p in pattern.panels
    )
    return replace(pattern, panels=panels)


def _quadratic(curve: Curve, chord: np.ndarray) -> Curve:
    """Through the middle of the curve."""
    if not isinstance(curve, Cubic | Arc):
        return curve
    through = evaluate(curve, chord, [0.5])[0]
    return Quadratic(to_relative(2 * through - chord.mean(axis=0), chord))


def in_t_pose(pattern: Pattern) -> Pattern:
    """The garment for a body in T-pose around the origin, in this package's reading of the angles."""
    old = old_style(with_quadratics(pattern)).with_rotation_reading("extrinsic")
    panels = tuple(type(p)(p.name, p.vertices, p.edges, p.placement.read_as("intrinsic")) for p in old.panels)
    return Pattern(panels, old.stitches)


def _save(path: Path, content) -> None:
    path.parent.mkdir(parents=True, exist_ok=True)
    path.write_text(json.dumps(content, indent=2))


# The systems


def garmentcode(root: Path, patterns: Mapping[str, Pattern]) -> list[str]:
    """``test_garmentcode.py``, and ``test_garment_sim.py`` after it for every third."""
    for k, (name, pattern) in enumerate(patterns.items()):
        folder = root / f"{name}_241124-18-30-05"
        _save(folder / f"{name}_specification.json", to_specification(pattern))
        (folder / f"{name}_pattern.svg").write_text("<svg/>")
        (folder / "body_measurements.yaml").write_text("body: {height: 171.99}\n")
        if k % 3 == 0:
            _save(folder / name / f"{name}_specification.json", to_specification(pattern))
            (folder / name / f"{name}_sim.obj").write_text("v 0 0 0\n")
            write_pickle(folder / name / f"{name}_orig_lens.pickle")
    return list(patterns)


def aipparel(root: Path, patterns: Mapping[str, Pattern]) -> list[str]:
    """``trainers/trainer.py``: the folder is made first, and stays empty where the answer has no panels."""
    section = root / "step_12750" / "valid"
    for k, (name, pattern) in enumerate(patterns.items()):
        folder = section / name
        content = predicted(pattern, dangling=k % DANGLING_EVERY == 0)
        _save(folder / "NNSewingPattern_pred_specification.json", content)
        _save(folder / f"{name}_gt_specification.json", predicted(pattern))
        for kind in ("NNSewingPattern_pred", f"{name}_gt"):
            (folder / f"{kind}_pattern.svg").write_text("<svg/>")
            (folder / f"{kind}_pattern.png").write_bytes(PNG)
        (folder / "output.txt").write_text("Question: ...\nOutput Text: ...\n")
        (folder / "input.png").write_bytes(PNG)
    (section / "rand_UNDECODED").mkdir()
    (section / "errored_texts0.txt").write_text("Error Type: DecodeErrorTypes.UNMATCHED_PANEL_TOKENS\n")
    return list(patterns)


def chatgarment(root: Path, patterns: Mapping[str, Pattern]) -> list[str]:
    """``scripts/evaluate_garment_v2_imggen_1float.py``, ``run_garmentcode_sim.py``: two garments or one."""
    shown = root / "example_imgs_img_recon" / "vis_new"
    ids, specifications = [], []
    names = list(patterns)
    for k in range(0, len(names), 2):
        both = k % 4 == 0 and k + 1 < len(names)
        groups = (
            [[("upper", names[k]), ("lower", names[k + 1])]]
            if both
            else [[("wholebody", n)] for n in names[k : k + 2]]
        )
        for group in groups:
            image = group[0][1]
            folder = shown / f"valid_garment_{image}.png"
            for part, name in group:
                tag = f"valid_garment_{part}"
                file = folder / tag / f"{tag}_specification.json"
                _save(file, to_specification(patterns[name]))
                (folder / tag / "design.yaml").write_text("design: {}\n")
                (folder / tag / "body_measurements.yaml").write_text("body: {}\n")
                _save(folder / tag / tag / f"{tag}_specification.json", to_specification(patterns[name]))
                (folder / tag / tag / f"{tag}_sim.obj").write_text("v 0 0 0\n")
                specifications.append(str(file))
                ids.append(image if part == "wholebody" else f"{image}_{part}")
            (folder / "output.txt").write_text("{}")
            (folder / "gt_image.png").write_bytes(PNG)
    (shown / "valid_garment_undecoded.png").mkdir()
    (shown / "valid_garment_undecoded.png" / "output.txt").write_text("{")
    _save(shown / "all_json_spec_files.json", specifications)
    return ids


def sewingldm(root: Path, patterns: Mapping[str, Pattern]) -> list[str]:
    """``scripts/dress_multimodal_condition.py``: one run a folder, all called alike; and batches."""
    ids = []
    for k, (name, pattern) in enumerate(patterns.items()):
        lower = [p.name for p in pattern.panels if p.label == "leg" and not p.name.startswith("wb")]
        names = {
            panel: f"bottom_panel_{i}" for i, panel in enumerate(lower)
        }  # skirts and trousers share slots
        content = predicted(pattern, names=names, dangling=k % DANGLING_EVERY == 0)
        content["pattern"]["new_panel_ids"] = [*range(len(pattern.panels)), *[None] * 3]
        for written, stitch in zip(content["pattern"]["stitches"], pattern.stitches, strict=True):
            written += ["right_wrong"] if stitch.right_wrong else []
        if k % 2:
            run = f"2026-11-24_{name}_scale4.5_step100_sampiddpm_seed{k}_use_text_no_sketch"
            tag = "outside_dataset_outside_dataset_"
            _save(root / run / tag / f"{tag}_specification.json", content)
            ids.append(run)
        else:
            pname = f"default_body__{name}"
            folder = root / "test" / f"{pname}__predicted_"
            content["properties"]["correct_num_panels"] = len(pattern.panels)
            _save(folder / f"{pname}__predicted__specification.json", content)
            _save(
                folder / f"{name}_specification.json", to_specification(pattern)
            )  # what it should have made
            (folder / "free_text.txt").write_text("Use text")
            ids.append(pname)
    return ids


def sewformer(root: Path, patterns: Mapping[str, Pattern]) -> list[str]:
    """``inference.py`` on pictures, and on SewFactory, where what it should have made is copied beside."""
    ids = []
    for k, (name, pattern) in enumerate(patterns.items()):
        content = predicted(in_t_pose(pattern), quadratic_only=True, dangling=k % DANGLING_EVERY == 0)
        content["pattern"]["new_panel_ids"] = [*range(len(pattern.panels)), *[None] * 3]
        if k % 2:
            _save(root / name / "_predicted_single_specification.json", content)
            (root / name / f"{name}.jpg").write_bytes(b"\xff\xd8")
            ids.append(name)
        else:
            pname = f"{name}_dress__{name}_cam0"
            content["properties"]["correct_num_panels"] = len(pattern.panels)
            _save(root / pname / "_predicted_specification.json", content)
            _save(root / pname / "_gt_specification.json", content)
            _save(root / pname / "spec_config.json", {"spec": {}})
            (root / pname / "_predicted_pattern.svg").write_text("<svg/>")
            ids.append(pname)
    return ids


def dresscode(root: Path, patterns: Mapping[str, Pattern]) -> list[str]:
    """``nn/evaluation_scripts/predict_class.py``: panels by number; second garments moved off the body."""
    for k, pattern in enumerate(patterns.values()):
        names = {p.name: f"panel_{i}" for i, p in enumerate(pattern.panels)}
        content = predicted(in_t_pose(pattern), quadratic_only=True, names=names)
        content["pattern"]["new_panel_ids"] = list(range(len(pattern.panels)))
        folder = root / STAMP / f"{k:03d}"
        if k % 5 == 1:
            _save(folder / "pred_0" / "specification_backup.json", content)
            content = json.loads(json.dumps(content))
            for panel in content["pattern"]["panels"].values():
                panel["translation"][2] += 10.0 * np.sign(panel["translation"][2])
        _save(folder / "pred_0" / "specification.json", content)
        (folder / "pred_0" / "_pattern.png").write_bytes(PNG)
        (folder / "caption.txt").write_text("dress, sleeveless")
    (root / STAMP / "900").mkdir()
    (root / STAMP / "900" / "caption.txt").write_text("pants")
    return [f"{k:03d}" for k in range(len(patterns))]


def design2garmentcode(root: Path, patterns: Mapping[str, Pattern]) -> list[str]:
    """``lmm_utils/helper.py``: the pattern is called like its folder; texts are written before it."""
    for name, pattern in patterns.items():
        folder = root / "examples" / name
        _save(folder / f"{name}.json", to_specification(pattern))
        _notes(folder)
        (folder / f"{name}.png").write_bytes(PNG)
        (folder / f"{name}_pattern.png").write_bytes(PNG)
        (folder / f"{name}.yaml").write_text("design: {}\n")
    (root / "examples" / "unfit").mkdir()
    _notes(root / "examples" / "unfit")
    return list(patterns)


def _notes(folder: Path) -> None:
    _save(folder / "caption.json", ["upper garment: shirt"])
    (folder / "gpt_respond.txt").write_text("A shirt.")
    (folder / "pattern_generate_time.txt").write_text("pattern_generate_time: 9.0 s\n")


def pattern_generator(root: Path, patterns: Mapping[str, Pattern]) -> list[str]:
    """``data_generation/datagenerator.py``: a template beside them, parameters, any unit."""
    data = root / f"data_20_tee_{STAMP}"
    for k, (name, pattern) in enumerate(patterns.items()):
        content = predicted(in_t_pose(pattern), quadratic_only=True)
        content["parameters"] = {
            "length": {"influence": [], "range": [0.5, 1.5], "value": 1.1, "type": "length"}
        }
        content["parameter_order"] = ["length"]
        content["constraints"], content["constraint_order"] = {}, []
        del content["pattern"]["panel_order"]
        if k % 3 == 0:
            content["properties"]["units_in_meter"] = 300
            for panel in content["pattern"]["panels"].values():
                panel["vertices"] = (np.array(panel["vertices"]) * 3).tolist()
                panel["translation"] = (np.array(panel["translation"]) * 3).tolist()
        _save(data / name / "specification.json", content)
        (data / name / f"{name}_sim.obj").write_text("v 0 0 0\n")
        (data / name / "_pattern.svg").write_text("<svg/>")
        if k == 0:
            _save(data / "tee_template_specification.json", content)
    _save(data / "dataset_properties.json", {"name": "data_20", "size": len(patterns)})
    return list(patterns)


# GarmageNet


def garmagenet(root: Path, patterns: Mapping[str, Pattern]) -> list[str]:
    """``batch_inference.py``, then GarmageJigsaw's ``extract_boundary_pts.py`` and ``inference_ps2es.py``."""
    (root / "sketch_cond").mkdir(parents=True)
    for k, (name, pattern) in enumerate(patterns.items()):
        write_pickle(root / "sketch_cond" / f"{name}.pkl")
        (root / "sketch_cond" / f"{name}_geo_img.png").write_bytes(PNG)
        extracted = root / "sketch_cond_extracted" / f"garment_{name}"
        drawn, notes, pieces = _style3d(pattern)
        if k == 0:  # a hole in the first panel, which has a contour of its own
            hole = {
                "type": 4,
                "circleType": 1,
                "edges": drawn["panels"][0]["seqEdges"][0]["edges"][:3],
                "vertices": [],
            }
            drawn["panels"][0]["seqEdges"].append(json.loads(json.dumps(hole)))
            pieces.insert(1, pieces[0][:9])
            notes["panel_instance_seg"].insert(1, 0)
            notes["contour_nes"].insert(1, 3)
            for pair in ([6, 0], [3, 6], [0, 3]):
                notes["edge_approx"].insert(len(drawn["panels"][0]["seqEdges"][0]["edges"]), pair)
        for i, points in enumerate(pieces):
            lines = "".join(f"v {x:.8f} {y:.8f} {z:.8f}\n" for x, y, z in points)
            extracted.mkdir(parents=True, exist_ok=True)
            (extracted / f"piece_{i:02d}.obj").write_text(lines)
        _save(extracted / "annotations" / f"garment_{name}.json", {**drawn, "stitches": []})
        _save(extracted / "annotations" / "annotations.json", notes)
        (extracted / "original_data").mkdir()
        write_pickle(extracted / "original_data" / f"{name}.pkl")
        sewn = root / "garmagejigsaw_output" / f"garment_{name}"
        _save(sewn / "garment.json", drawn)
        (sewn / "vis_comp.html").write_text("<html/>")
        write_pickle(sewn / "orig_data.pkl")
        write_pickle(sewn / "vis_resource.pkl")
    _save(root / "sketch_cond_extracted" / "data_info.json", {"RESO": 256, "delta": 0.012, "erode_size": 3})
    return list(patterns)


def _style3d(pattern: Pattern) -> tuple[dict, dict, list[np.ndarray]]:
    """Style3D's JSON, the notes of the extraction, and borders in space, m from (0, 1, 0).

    All panels are seen from their right side, so that their outlines all run the same way.
    """
    panels, pieces, counts, approx = [], [], [], []
    for number, panel in enumerate(pattern.panels):
        flip = np.array([np.sign(panel.signed_area()), 1.0])
        edges, space, ends = [], [], []
        center = np.array([300.0 + number, 1500.0])
        for k in range(len(panel.edges)):
            count = max(int(panel.edge_length(k) / 1.2) + 2, 2)
            ends.append([sum(len(s) for s in space), 0])
            space.append(panel.to_world(panel.sample_edge(k, count))[:-1])
            points = panel.sample_edge(k, 10) if count > 8 else panel.sample_edge(k, 2)
            local = points * flip * 10.0 - center
            controls = [[x, y, 0] for x, y in local.tolist()]
            edges.append({"bezierPoints": [[0, 0, 0]] * 2, "controlPoints": controls, "id": f"e{number}_{k}"})
        for k, pair in enumerate(ends):
            pair[1] = ends[(k + 1) % len(ends)][0]
        outline = {
            "type": 3,
            "circleType": 0,
            "edges": edges,
            "vertices": [e["controlPoints"][0] for e in edges],
        }
        panels.append(
            {"center": center.tolist(), "seqEdges": [outline], "id": f"p{number}", "label": f"{number:02d}"}
        )
        pieces.append((np.concatenate(space) - [0.0, 100.0, 0.0]) / 100.0)
        counts.append(len(edges))
        approx += ends
    index = {p.name: k for k, p in enumerate(pattern.panels)}

    def end(ref, share: float) -> dict:
        number = index[ref.panel]
        return {"clothPieceId": f"p{number}", "edgeId": f"e{number}_{ref.edge}", "param": share}

    stitches = []
    for s in pattern.stitches:
        against = not s.right_wrong
        first = {"start": end(s.first, 1e-5), "end": end(s.first, 1 - 1e-5), "isCounterClockWise": False}
        low, high = (1 - 1e-5, 1e-5) if against else (1e-5, 1 - 1e-5)
        second = {"start": end(s.second, low), "end": end(s.second, high), "isCounterClockWise": against}
        stitches.append([first, second])
    notes = {
        "panel_nes": list(counts),
        "contour_nes": counts,
        "edge_approx": approx,
        "panel_instance_seg": list(range(len(panels))),
        "data_path": "x.pkl",
    }
    return {"panels": panels, "stitches": stitches}, notes, pieces


WRITERS = {
    "garmentcode": garmentcode,
    "aipparel": aipparel,
    "chatgarment": chatgarment,
    "sewingldm": sewingldm,
    "sewformer": sewformer,
    "dresscode": dresscode,
    "design2garmentcode": design2garmentcode,
    "garment-pattern-generator": pattern_generator,
    "garmagenet": garmagenet,
}
FAILED = {"aipparel": 1, "chatgarment": 1, "dresscode": 1, "design2garmentcode": 1}
"""How many inputs of a writer's folder have no pattern."""
