"""Wishes cut into a pattern without any network: statements that are to hold, measures that are to grow.

python examples/recut_a_pattern.py
"""

import swifttailor

shirt = swifttailor.draft("t-shirt")
wishes = ["sleeves=long", "neckline=v", "length +12"]
altered = swifttailor.alter(shirt, wishes)
for cut in altered.cuts:
    print("cut:", cut)
assert not altered.open, altered.open

before, after = (swifttailor.describe(pattern).facts for pattern in (shirt, altered.pattern))
print(f"{before.length:.1f} cm long before, {after.length:.1f} cm now")
assert swifttailor.Claim("sleeves", "long").holds(after)
altered.pattern.save("long-sleeved.json")
