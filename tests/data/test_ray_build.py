"""A build on a Ray cluster of two nodes on this machine; needs the extra `cluster`."""

from __future__ import annotations

import importlib.util
import json
import os
import subprocess
import sys
from pathlib import Path

import pytest
from sample_makers import COARSE, make_quickly, split_content

from swifttailor.data.builder import build_split
from swifttailor.pattern.pattern_list import read_patterns
from swifttailor.workers import Outcome

needs_ray = pytest.mark.skipif(
    importlib.util.find_spec("ray") is None, reason="ray is not installed (extra 'cluster')"
)

# In a process of its own: Ray leaves threads and warnings behind.
PROGRAM = """
import os, signal, sys
from functools import partial
from pathlib import Path

import psutil
import ray
from ray.cluster_utils import Cluster

from sample_makers import COARSE, make_slowly
from swifttailor.data.builder import build_split
from swifttailor.pattern.pattern_list import read_patterns
from swifttailor.workers.ray_pool import run_tasks_on_ray

source, out, address = Path(sys.argv[1]), Path(sys.argv[2]), sys.argv[3]
nodes, seen, killed = set(), [], []
if address == "cluster":
    cluster = Cluster(initialize_head=True, head_node_args={"num_cpus": 1, "include_dashboard": False})
    second = cluster.add_node(num_cpus=1)
    cluster.wait_for_nodes()
    address = cluster.address

def on_record(record):
    seen.append(record["id"])
    if ray.is_initialized():
        nodes.update(n["NodeID"] for n in ray.nodes() if n["Alive"])
    if len(seen) == 3:  # a worker dies in the middle of its work
        everything = psutil.Process().children(recursive=True)
        workers = [p for p in everything if "ray::Actor" in " ".join(p.cmdline())]
        workers[-1].kill()
        killed.append(workers[-1].pid)
    if len(seen) == 8 and len(sys.argv) > 4:  # a machine leaves
        cluster.remove_node(second)

runner = partial(run_tasks_on_ray, address=address, time_limit=60, attempts=3)
patterns = read_patterns(source)
index = build_split(patterns, out, "train", COARSE, runner=runner, on_record=on_record, make=make_slowly)
print("RESULT", len(nodes), len(killed), len(seen), index.complete)
"""


def here(function, tasks):
    for task in tasks:
        yield Outcome(task, function(task))


@needs_ray
@pytest.mark.timeout(400)
@pytest.mark.parametrize("a_machine_leaves", [False, True])
def test_a_cluster_of_two_with_a_worker_killed_gives_the_same_shards(
    a_machine_leaves, patterns_file, tmp_path
):
    ids = [f"bad-{k}" if k % 5 == 4 else f"p{k}" for k in range(18)]
    source = patterns_file(*ids)
    build_split(read_patterns(source), tmp_path / "here", "train", COARSE, runner=here, make=make_quickly)
    script = tmp_path / "script.py"
    script.write_text(PROGRAM)
    more = ["leaves"] if a_machine_leaves else []
    done = subprocess.run(
        [sys.executable, str(script), str(source), str(tmp_path / "ray"), "cluster", *more],
        env=os.environ | {"PYTHONPATH": os.pathsep.join([str(Path(__file__).parent), *sys.path])},
        capture_output=True,
        text=True,
        timeout=380,
    )
    assert done.returncode == 0, done.stderr[-3000:]
    assert "RESULT 2 1 18 True" in done.stdout
    assert len(split_content(tmp_path / "here")) == 6  # five shards and the index
    assert split_content(tmp_path / "ray") == split_content(tmp_path / "here")
    lines = (tmp_path / "ray" / "train" / "results.jsonl").read_text().splitlines()
    assert sorted(json.loads(line)["position"] for line in lines) == list(range(18))


@needs_ray
def test_no_cluster_at_the_address():
    program = (
        "from swifttailor.workers.ray_pool import run_tasks_on_ray\n"
        "from swifttailor.errors import InputError\n"
        "try: list(run_tasks_on_ray(print, [1], address='127.0.0.1:1', time_limit=5))\n"
        "except InputError as error: print('REFUSED', error)\n"
    )
    done = subprocess.run(
        [sys.executable, "-c", program],
        env=os.environ | {"PYTHONPATH": os.pathsep.join(sys.path)},
        capture_output=True,
        text=True,
        timeout=60,
    )
    assert "REFUSED There is no Ray cluster at '127.0.0.1:1'" in done.stdout, done.stderr[-2000:]


def test_without_ray_the_extra_is_named(monkeypatch):
    from swifttailor.errors import MissingExtraError
    from swifttailor.workers.ray_pool import run_tasks_on_ray

    monkeypatch.setitem(sys.modules, "ray", None)
    with pytest.raises(MissingExtraError, match=r"swifttailor\[cluster\]"):
        next(run_tasks_on_ray(print, [1], address="local", time_limit=5))
