"""From words to a sewing pattern and its garment.

python examples/from_words.py
"""

import swifttailor

tailor = swifttailor.Tailor.load()
dress = tailor.generate("a knee-length sleeveless dress with a V neck", seed=0)
dress.save("dress")

# What was asked for can be measured on the pattern that was cut.
shown = swifttailor.describe(dress.pattern)
print(shown)
for wanted in ("kind=dress", "skirt_hem=knee", "sleeves=none", "neckline=v"):
    name, value = wanted.split("=")
    assert swifttailor.Claim(name, value).holds(shown.facts), wanted
