"""Patterns drawn by latent diffusion over a panel tensor, in the manner of SewingLDM: to compare with.

An auto-encoder brings the tensor of a pattern into few numbers, a denoiser draws such numbers for what is
sought, and the decoder turns them into a pattern. No weights come with the package:
`runs/latent_diffusion.sh` makes them.

May import `parameter_reader`, `pattern_library` and what these may import.
"""
