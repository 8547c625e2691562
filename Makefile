# What can be done with this repository: `make help`. Nothing needs to be installed first but Python 3.11 and
# GNU make; every target sets up .venv/ by itself.

SHELL := bash
.SHELLFLAGS := -eu -o pipefail -c
.DEFAULT_GOAL := help
.DELETE_ON_ERROR:

BIN := .venv/bin
READY := .venv/.ready
JOBS ?= 2
GARMENTCODE ?= $(or $(SWIFTTAILOR_GARMENTCODE),../shared/garmentcode)
MAKER_WEIGHTS := src/swifttailor/pattern_maker/pattern_maker.zip
SEWER_WEIGHTS := src/swifttailor/garment_sewer/garment_sewer.onnx
# What the demonstration shows is a matter of the weights that are there.
DEMO := $(if $(wildcard $(SEWER_WEIGHTS)),$(if $(wildcard $(MAKER_WEIGHTS)),demo-generate,demo-sew),demo-drape)

help:  ## show this list
	@awk -F ':.*## ' '/^[a-z-]+:.*## /{printf "  make %-12s %s\n", $$1, $$2}' $(MAKEFILE_LIST)

setup: $(READY)  ## make .venv with the pinned development packages and this package, editable

$(READY): pyproject.toml requirements/dev.txt
	@uv=$$(scripts/find_uv.sh); \
	echo 'Setting up .venv/ ...'; \
	[ -x $(BIN)/python ] || "$$uv" venv --quiet .venv; \
	"$$uv" pip install --quiet --compile-bytecode --python $(BIN)/python -r requirements/dev.txt -e .
	@touch $@

demo: $(DEMO)  ## a garment of words if the package has the weights, else of a drafted pattern, into ./demo/

demo-generate: $(READY)
	@echo 'The package has trained weights: a dress of words, then changed by words.'; mkdir -p demo
	$(BIN)/swifttailor generate 'a knee-length sleeveless dress with a V neck' --out demo/words || [ $$? -eq 1 ]
	$(BIN)/swifttailor edit demo/words 'make it 15 cm longer' --out demo/longer || [ $$? -eq 1 ]
	@echo; echo "Made:"; ls demo/{words,longer}/{preview.png,garment.glb,pattern.svg}

demo-sew: $(READY)
	@echo 'This version has no weights that read words ($(notdir $(MAKER_WEIGHTS))): drafted patterns are sewn.'; mkdir -p demo
	for name in shirt-dress hoodie trousers; do $(BIN)/swifttailor draft $$name --out demo/$$name.json; done
	$(BIN)/swifttailor sew demo/shirt-dress.json demo/hoodie.json demo/trousers.json --out demo --preview || [ $$? -eq 1 ]
	@real='$(GARMENTCODE)/dress_pencil_specification.json'; \
	if [ -f "$$real" ]; then \
		echo "$(BIN)/swifttailor sew $$real --out demo/real --preview"; \
		$(BIN)/swifttailor sew "$$real" --out demo/real --preview || [ $$? -eq 1 ]; \
	fi
	@echo; echo "Made:"; ls demo/*/preview.png demo/*/garment.glb demo/*/pattern.svg

demo-drape: $(READY)
	@echo 'This version has no trained weights ($(notdir $(MAKER_WEIGHTS)), $(notdir $(SEWER_WEIGHTS))), so no words:'
	@echo 'a draft is draped by physics instead.'; mkdir -p demo
	$(BIN)/swifttailor draft shirt-dress --out demo/dress.json
	$(BIN)/swifttailor drape demo/dress.json --out demo/dress || [ $$? -eq 1 ]
	@real='$(GARMENTCODE)/dress_pencil_specification.json'; \
	if [ -f "$$real" ]; then \
		echo "$(BIN)/swifttailor drape $$real --out demo/real"; \
		$(BIN)/swifttailor drape "$$real" --out demo/real || [ $$? -eq 1 ]; \
	fi
	@echo; echo "Made:"; ls demo/*/preview.png demo/*/garment.glb demo/*/pattern.svg

test: $(READY)  ## run all tests on JOBS processes (2)
	$(BIN)/python -m pytest -n $(JOBS)

lint: $(READY)  ## look for faults in the code
	$(BIN)/ruff check .
	$(BIN)/ruff format --check .

format: $(READY)  ## lay the code out and mend what can be mended
	$(BIN)/ruff format .
	$(BIN)/ruff check --fix .

types: $(READY)  ## check the type annotations
	$(BIN)/ty check src/swifttailor

bench: $(READY)  ## time drapes, stage by stage
	$(BIN)/python benchmarks/drape_stages.py

lock:  ## pin the newest development packages in requirements/dev.txt
	uv=$$(scripts/find_uv.sh); \
	"$$uv" pip compile --quiet --upgrade --universal --python-version 3.11 pyproject.toml --group dev \
		--no-emit-index-url --no-header --no-annotate --output-file requirements/dev.txt

clean-cache:  ## delete numba's compiled code: it does not see changes in modules that a kernel calls
	find src tests -name '*.nb[ic]' -delete

clean: clean-cache  ## delete everything that was made, .venv included
	rm -rf .venv .uv demo out .pytest_cache .ruff_cache .hypothesis dist build

.PHONY: help setup demo demo-generate demo-sew demo-drape test lint format types bench lock clean-cache clean
