"""The API, fuzzed from its own description."""

from __future__ import annotations

import os
from pathlib import Path

import pytest
import schemathesis
from hypothesis import HealthCheck, given, settings
from schemathesis.checks import not_a_server_error
from schemathesis.specs.openapi.checks import (
    content_type_conformance,
    response_schema_conformance,
    status_code_conformance,
)

from swifttailor.studio.app.application import make_application

EXAMPLES = int(os.environ.get("SWIFTTAILOR_SCHEMA_EXAMPLES", "10"))
"""Of each route."""
CHECKS = [
    not_a_server_error,
    status_code_conformance,
    content_type_conformance,
    response_schema_conformance,
]
TOLD = (501, 503, 504, 507)
"""Of a server that has too much to do, or lacks something: as described, and no fault of it."""

_SCHEMA = schemathesis.openapi.from_dict(make_application(Path("nowhere"))._app.openapi())
OPERATIONS = [found.ok() for found in _SCHEMA.get_all_operations()]


@pytest.mark.parametrize("operation", OPERATIONS, ids=lambda o: f"{o.method} {o.path}")
def test_answers_are_as_described(operation, studio):
    answered = []

    @given(case=operation.as_strategy())
    @settings(max_examples=EXAMPLES, deadline=None, suppress_health_check=list(HealthCheck))
    def fuzz(case):
        answer = case.call(base_url=studio.address, timeout=120)
        answered.append(answer.status_code)
        if answer.status_code in TOLD:
            assert answer.json()["error"]["message"]
        else:
            case.validate_response(answer, checks=CHECKS)

    fuzz()
    assert answered
