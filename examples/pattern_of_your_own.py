"""A pattern made of panels, edges and stitches: a straight skirt of two rectangles, checked and draped.

python examples/pattern_of_your_own.py
"""

import swifttailor
from swifttailor import Edge, EdgeRef, Panel, Pattern, Placement, Stitch

# Corners in cm, in the panel's own plane; edge k joins corner k to k + 1. Seen from the right side of the
# cloth, the front goes around anticlockwise; the back, which faces away, the other way around.
corners = [[-26.0, 0.0], [26.0, 0.0], [23.0, 50.0], [-23.0, 50.0]]
front = Panel("front", corners, (Edge(),) * 4, Placement((0.0, 50.0, 25.0)))
back = Panel("back", corners[::-1], (Edge(),) * 4, Placement((0.0, 50.0, -25.0)))
sides = (Stitch(EdgeRef("front", 1), EdgeRef("back", 1)), Stitch(EdgeRef("front", 3), EdgeRef("back", 3)))
skirt = Pattern((front, back), sides, "straight skirt")

assert not [finding for finding in swifttailor.check(skirt) if finding.severity.value == "error"]
skirt.save("skirt.json")
assert swifttailor.load_pattern("skirt.json").panels == skirt.panels

garment = swifttailor.drape(skirt, fabric="denim", edge_length=4.0)
garment.save("skirt", preview=False)
print(garment.report["quality"])
assert garment.report["quality"]["seam_gap_max_cm"] == 0
