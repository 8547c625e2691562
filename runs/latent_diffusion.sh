#!/usr/bin/env bash
# A latent diffusion over panel tensors from nothing, in the manner of SewingLDM: to compare with (docs/evaluation.md,
# Systems). It is no part of the package.
#
#   GARMENTCODE=FOLDER runs/latent_diffusion.sh
#
# steps.sh lists the environment, data.sh says how long the patterns take. SEWN is a list of splits of sewn garments, such as
# those of picture_reader.sh, whose pictures are read. Patterns are measured, 0.1 s of a core each, pictures read, 0.1 s
# each. MINUTES are those of a core for the auto-encoder and for the denoiser, in quotation marks ("20 25" without it).
# Ends with $WORK/latent-diffusion/latent_diffusion.zip and its card beside it; then
#
#   swifttailor evaluate systems ... --generators sewing-ldm=$WORK/latent-diffusion/latent_diffusion.zip
source "$(dirname "${BASH_SOURCE[0]}")/steps.sh"

runs/data.sh patterns
read -ra minutes <<< "${MINUTES:-20 25}"
read -ra sewn <<< "${SEWN:-}"
options=(--minutes "${minutes[@]}")
[ -n "$rehearse" ] && options+=(--steps 3 3)
[ ${#sewn[@]} -gt 0 ] && options+=(--data "${sewn[@]}")
mkdir -p "$work/latent-diffusion"
step latent-diffusion-made "$python" scripts/train_latent_diffusion_torch.py --patterns "$work"/patterns/train*.jsonl.gz \
    --validation "$work/patterns/validation.jsonl.gz" --apart "$work/patterns/test.jsonl.gz" "${options[@]}" \
    --cache "$work/measured" --run "$work/latent-diffusion/run" --out "$work/latent-diffusion/latent_diffusion.zip"
