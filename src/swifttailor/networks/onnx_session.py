"""Opening ONNX graphs with onnxruntime."""

from __future__ import annotations

from typing import Any

from swifttailor.errors import InputError


def open_session(graph: bytes, source: str, model: str, *, threads: int = 1) -> Any:
    """Opens a graph.

    Args:
        graph: The content of an .onnx file.
        source: Where it comes from, for messages.
        model: What it should be, for messages.
        threads: Processor cores to run on.

    Returns:
        The onnxruntime session.

    Raises:
        InputError: It is no graph that can be run.
    """
    import onnxruntime

    options = onnxruntime.SessionOptions()
    options.intra_op_num_threads = threads
    options.inter_op_num_threads = 1
    options.log_severity_level = 4  # what is wrong is said below
    # Processors without dot products of bytes would cut sums of products off; slower kernels do not.
    options.add_session_config_entry("session.x64quantprecision", "1")
    try:
        return onnxruntime.InferenceSession(graph, options, providers=["CPUExecutionProvider"])
    except Exception as error:  # onnxruntime has a dozen kinds, none of them public
        lines = str(error).strip().splitlines()
        reason = lines[0][:200] if lines else type(error).__name__
        raise InputError(
            f"'{source}' is not a network that can be run, or is damaged ({reason}). Give the file of a "
            f"{model}, or copy it again from its source."
        ) from error
