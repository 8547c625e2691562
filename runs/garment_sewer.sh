#!/usr/bin/env bash
# GarmentSewer from nothing: patterns, drapes, a training from random weights, the model file.
#
#   GARMENTCODE=FOLDER runs/garment_sewer.sh
#
# steps.sh lists the environment, data.sh says how long the data take. The training takes MINUTES (190: what that of
# the package has had on one core of a server), on a GPU where there is one; it goes on where it was interrupted. Ends with
# $WORK/garment-sewer/garment_sewer.onnx and its card beside it.
source "$(dirname "${BASH_SOURCE[0]}")/steps.sh"

set_values validate_every=300 validation_garments=140
if [ -n "$rehearse" ]; then
    set_values steps=4 batch_size=2 validate_every=2 log_every=1 pictures=1 network.resolution=64 \
        network.hidden_size=16 network.layers=2 network.heads=2 "network.convolutions=[4,4,8,8]" \
        "network.decoder_sizes=[8,8,8,8]" network.fusion_size=8 network.input_skip=4
fi

runs/data.sh patterns drapes
step sewer-trained train garment-sewer --data "$work/garments" --config small --max-minutes "${MINUTES:-190}" \
    --set "${settings[@]}"
step sewer-exported swifttailor train export "$work/garment-sewer/run" --out "$work/garment-sewer/garment_sewer.onnx" --overwrite --half
