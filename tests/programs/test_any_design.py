"""Whatever the parameters are, there is a pattern that can be read or an error that says why not."""

from __future__ import annotations

from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st

from swifttailor.pattern import Severity, check_pattern, read_specification, to_specification
from swifttailor.programs import DESIGN_PARAMETERS, DesignError, make_pattern

SEWN_AS_IS = {"self-crossing"}
"""What GarmentCode's programs may draw, and its sampler throws away."""


def values_of(parameter):
    if parameter.choices:
        return st.sampled_from(parameter.choices)
    low, high = parameter.range
    return st.integers(int(low), int(high)) if parameter.kind == "int" else st.floats(low, high)


designs = st.fixed_dictionaries({name: values_of(p) for name, p in DESIGN_PARAMETERS.items()})


@settings(max_examples=60, deadline=None, suppress_health_check=list(HealthCheck))
@given(designs)
def test_a_pattern_or_an_error(design):
    try:
        pattern = make_pattern(design)
    except DesignError as error:
        assert 40 < len(str(error)) < 600
        return
    assert read_specification(to_specification(pattern)).findings == ()
    assert all(pattern.has_edge(side) for stitch in pattern.stitches for side in stitch.sides)
    errors = {f.code for f in check_pattern(pattern) if f.severity is Severity.ERROR}
    assert errors <= SEWN_AS_IS
