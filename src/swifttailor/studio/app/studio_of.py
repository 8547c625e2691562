"""The studio that a request is for."""

from __future__ import annotations

from fastapi import Request

from swifttailor.studio.service import Studio


def studio_of(request: Request) -> Studio:
    """The one studio of the application."""
    studio: Studio = request.app.state.studio
    return studio
