from __future__ import annotations

import pytest
from draft_checks import assert_sound, bodies, options_of
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st

from swifttailor.pattern.drafts import draft, list_drafts


@pytest.mark.parametrize("info", list_drafts(), ids=lambda d: d.name)
@settings(max_examples=10, deadline=None, suppress_health_check=list(HealthCheck), derandomize=True)
@given(data=st.data())
def test_stays_sewable(info, data):
    measurements = data.draw(bodies())
    options = data.draw(options_of(info))
    assert_sound(draft(info.name, measurements=measurements, **options))
