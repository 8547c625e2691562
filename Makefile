# What can be done with this repository: `make help`. Nothing needs to be installed first but Python 3.11 and
# GNU make; every target sets up .venv/ by itself, and those of the networks .venv-networks/.

SHELL := bash
.SHELLFLAGS := -eu -o pipefail -c
.DEFAULT_GOAL := help
.DELETE_ON_ERROR:

BIN := .venv/bin
READY := .venv/.ready
NETWORKS_BIN := .venv-networks/bin
NETWORKS_READY := .venv-networks/.ready
JOBS ?= 2
GARMENTCODE ?= $(or $(SWIFTTAILOR_GARMENTCODE),../shared/garmentcode)
MAKER_WEIGHTS := src/swifttailor/pattern_maker/pattern_maker.zip
SEWER_WEIGHTS := src/swifttailor/garment_sewer/garment_sewer.onnx
# torch asks for these on Linux, a quarter of the whole, and loads them only to compute on a GPU.
NOT_ON_CPU := triton cuda-bindings cuda-pathfinder nvidia-cuda-cccl nvidia-cusolver nvidia-nvjitlink nvidia-nvtx
# What the demonstration shows is a matter of the weights that are there.
DEMO := $(if $(wildcard $(SEWER_WEIGHTS)),$(if $(wildcard $(MAKER_WEIGHTS)),demo-generate,demo-sew),demo-drape)

# Python keeps what it has compiled, whoever calls: else each of the tests' hundreds of processes compiles torch anew.
unexport PYTHONDONTWRITEBYTECODE

help:  ## show this list
	@awk -F ':.*## ' '/^[a-z-]+:.*## /{printf "  make %-14s %s\n", $$1, $$2}' $(MAKEFILE_LIST)

setup: $(READY)  ## make .venv with the pinned development packages and this package, editable

$(READY): pyproject.toml requirements/dev.txt
	@uv=$$(scripts/find_uv.sh); \
	echo 'Setting up .venv/ ...'; \
	[ -x $(BIN)/python ] || "$$uv" venv --quiet .venv; \
	"$$uv" pip install --quiet --compile-bytecode --python $(BIN)/python -r requirements/dev.txt -e .
	@touch $@

setup-networks: $(NETWORKS_READY)  ## make .venv-networks, which has torch and the rest of the extra `train` too (5 GB)

# Exactly what the lock file says, which leaves out what torch asks for but works without on a CPU (see `lock`).
$(NETWORKS_READY): pyproject.toml requirements/networks.txt
	@uv=$$(scripts/find_uv.sh); \
	echo 'Setting up .venv-networks/ (2 GB to download the first time) ...'; \
	[ -x $(NETWORKS_BIN)/python ] || "$$uv" venv --quiet .venv-networks; \
	"$$uv" pip sync --quiet --python $(NETWORKS_BIN)/python requirements/networks.txt; \
	"$$uv" pip install --quiet --no-deps --python $(NETWORKS_BIN)/python -e .
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
	$(BIN)/swifttailor sew demo/shirt-dress.json demo/hoodie.json demo/trousers.json --out demo || [ $$? -eq 1 ]
	@real='$(GARMENTCODE)/dress_pencil_specification.json'; \
	if [ -f "$$real" ]; then \
		echo "$(BIN)/swifttailor sew $$real --out demo/real"; \
		$(BIN)/swifttailor sew "$$real" --out demo/real || [ $$? -eq 1 ]; \
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

# One thread each: threads of several processes on the same cores wait for each other.
test: $(READY)  ## run all tests but those of torch, on JOBS processes (2)
	OMP_NUM_THREADS=1 $(BIN)/python -m pytest -n $(JOBS)

# File by file: what one test of a file has trained, others of it look at. The recipes take as long as everything
# else, and so come first.
test-networks: $(NETWORKS_READY)  ## run the tests of torch, on JOBS processes (2)
	OMP_NUM_THREADS=1 $(NETWORKS_BIN)/python -m pytest -n $(JOBS) --dist loadfile --no-loadscope-reorder --timeout 900 \
		-m needs_torch tests/training/test_recipes.py tests

lint: $(READY)  ## look for faults in the code
	$(BIN)/ruff check .
	$(BIN)/ruff format --check .

format: $(READY)  ## lay the code out and mend what can be mended
	$(BIN)/ruff format .
	$(BIN)/ruff check --fix .

types: $(READY)  ## check the type annotations, torch being anything
	$(BIN)/ty check src/swifttailor

types-networks: $(NETWORKS_READY)  ## check the type annotations with those of torch, transformers, onnx, ...
	$(NETWORKS_BIN)/ty check --python .venv-networks src/swifttailor

studio:  ## build the studio's page from studio-ui/ (needs Node 20); the built files are committed
	cd studio-ui && npm ci --no-audit --no-fund && npm run build

studio-check:  ## look for faults in the studio's page, and run its tests (needs Node 20)
	cd studio-ui && npm ci --no-audit --no-fund && npm run check

fuzz: $(READY)  ## feed damaged files to all readers: TARGETS (all), INPUTS (a minute's worth), SEED (0)
	$(BIN)/python -m fuzzing $(TARGETS) $(if $(INPUTS),--inputs $(INPUTS)) --seed $(or $(SEED),0)

bench: $(READY)  ## time drapes, stage by stage
	$(BIN)/python benchmarks/drape_stages.py

lock:  ## pin the newest development packages in requirements/dev.txt and networks.txt
	compile="$$(scripts/find_uv.sh) pip compile --quiet --upgrade --universal --python-version 3.11 pyproject.toml \
		--group dev --no-emit-index-url --no-header --no-annotate"; \
	$$compile --output-file requirements/dev.txt; \
	$$compile --output-file requirements/networks.txt --extra train --constraint requirements/dev.txt \
		$(NOT_ON_CPU:%=--no-emit-package %)

clean-cache:  ## delete numba's compiled code: it does not see changes in modules that a kernel calls
	find src tests \( -name '*.nb[ic]' -o -name '*.loop' \) -delete

clean: clean-cache  ## delete everything that was made, .venv included
	rm -rf .venv .venv-networks .uv demo out .pytest_cache .ruff_cache .hypothesis dist build

.PHONY: help setup setup-networks demo demo-generate demo-sew demo-drape test test-networks lint format types \
	types-networks studio studio-check fuzz bench lock clean-cache clean
