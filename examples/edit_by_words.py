"""A pattern changed by an instruction; what the instruction does not speak of stays.

python examples/edit_by_words.py
"""

import swifttailor

dress = swifttailor.draft("shirt-dress")
longer = swifttailor.Tailor.load().edit(dress, "make it 10 cm longer")
longer.save("longer-dress")

before, after = (swifttailor.describe(pattern).facts for pattern in (dress, longer.pattern))
print(f"{before.length:.1f} cm long before, {after.length:.1f} cm now")
assert abs(after.length - before.length - 10) < 1
kept = {panel.name for panel in dress.panels} & {panel.name for panel in longer.pattern.panels}
assert len(kept) == len(dress.panels)
