"""In what the network says lengths: plain numbers of about 1, for the training and for reading alike."""

from __future__ import annotations

BOX_CM = 50.0
"""Unit of the boxes of panels."""
MEASURE_CM = 10.0
"""Up to about here measures are off by the centimetre, beyond by share: ``asinh(measure / MEASURE_CM)``."""
NARROWEST, WIDEST = -5.0, 3.0
"""Logarithms of the widths of a measure's Laplace distribution that count, in the unit of asinh."""
VIEW_CM = 80.0
"""Between the two points of the wearer's axis whose distance in a picture is its scale."""
