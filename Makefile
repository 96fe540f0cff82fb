# The two commands: `make demo` and `make test`. All that they need goes into .venv.
PYTHON ?= python3
VENV := .venv
BIN := $(VENV)/bin
DEMO_TEXT := A vehicle tailgating another car at a four-way stop, leading to a sudden braking event as a pedestrian steps into the crosswalk.

.DEFAULT_GOAL := help
.PHONY: help demo quick test lint types layers asam interop benchmark bench docs gallery lock clean

help: ## what there is to make
	@grep -hE '^[a-z]+:.*##' $(MAKEFILE_LIST) | sed -E 's/^([a-z]+):.*## /  \1\t/' | expand -t 14

$(VENV)/.installed: pyproject.toml constraints.txt
	@$(PYTHON) -c 'import sys; sys.exit(sys.version_info < (3, 11))' || \
	  { echo "Python 3.11 or newer is needed; name one: make PYTHON=python3.12 $(MAKECMDGOALS)" >&2; exit 1; }
	@test -x $(BIN)/python || $(PYTHON) -m venv $(VENV)
	@echo "installing into $(VENV) (once, a minute or two)"
	@$(BIN)/python -m pip install --quiet --disable-pip-version-check -c constraints.txt -e '.[campaign,cluster,dev,docs,exchange,llm,web]'
	@touch $@

$(VENV)/asam/.installed: $(VENV)/.installed src/scegen/checking/data/asam-constraints.txt
	@echo "installing the ASAM checkers into $(VENV)/asam (once)"
	@$(BIN)/python -m scegen.checking.environment asam
	@touch $@

asam: $(VENV)/asam/.installed ## install the ASAM checkers in an environment of their own

demo: $(VENV)/.installed ## from a sentence to simulator files, in ./demo
	@$(MAKE) --no-print-directory asam || echo "going on without the ASAM checkers" >&2
	$(BIN)/scegen generate "$(DEMO_TEXT)" -o demo --count 2 --check full --force
	@echo "steer it yourself on the page: $(BIN)/scegen serve --open"

# What a change breaks first, package by package from the left: no search, no player, no model.
QUICK := tests/test_layout.py tests/test_units.py tests/scenario tests/road \
  tests/understanding --ignore=tests/understanding/agents \
  tests/enumeration/test_reference_table.py tests/motion/test_paths.py tests/motion/test_simulation.py \
  tests/measures tests/claims/test_hazard_predicates.py tests/export/test_opendrive.py \
  tests/export/test_openscenario.py tests/checking/test_opendrive.py tests/cli/test_layout.py

quick: $(VENV)/.installed ## the most telling tests, in less than a minute
	$(BIN)/python -m pytest -n 2 -m "not interop and not asam and not esmini" $(QUICK)

test: $(VENV)/asam/.installed ## all tests
	@command -v chromium >/dev/null || echo "no chromium on PATH: what pages do is not tested; install it: apt-get install chromium" >&2
	$(BIN)/python -m pytest -n 2 -m "not interop"

lint: $(VENV)/.installed ## ruff, mypy strict, import-linter
	$(BIN)/ruff check .
	$(BIN)/ruff format --check .
	$(BIN)/mypy
	$(BIN)/lint-imports

interop: $(VENV)/asam/.installed ## independent validators: ASAM, carla.Map, netconvert, esmini if present
	$(BIN)/python -m scegen.checking.environment interop
	$(BIN)/python -m pytest -n 2 -m "interop"

benchmark: $(VENV)/asam/.installed ## the source paper's eleven sentences
	$(BIN)/scegen benchmark paper

$(VENV)/crime/.installed: $(VENV)/.installed benchmarks/crime-constraints.txt
	@echo "installing commonroad-crime into $(VENV)/crime (once)"
	@$(BIN)/python -m venv $(VENV)/crime
	@$(VENV)/crime/bin/python -m pip install --quiet --disable-pip-version-check -c benchmarks/crime-constraints.txt commonroad-crime
	@touch $@

$(VENV)/bench/.installed: $(VENV)/.installed
	@$(BIN)/python -m pip install --quiet --disable-pip-version-check -c constraints.txt -e '.[bench]'
	@mkdir -p $(@D) && touch $@

bench: $(VENV)/bench/.installed ## all benchmarks into docs/reference/benchmarks.md; wants a quiet machine, takes a quarter of an hour
	@$(MAKE) --no-print-directory $(VENV)/crime/.installed || echo "going on without commonroad-crime" >&2
	$(BIN)/python benchmarks/table.py

docs: $(VENV)/.installed ## the documentation as pages, strictly, into build/site
	NO_MKDOCS_2_WARNING=1 $(BIN)/mkdocs build --quiet --strict

gallery: $(VENV)/.installed ## the pictures of the gallery alone, into build/gallery
	$(BIN)/python docs/making/gallery.py build/gallery

lock: ## pin what is installed now
	@{ sed -n '1p' constraints.txt; $(BIN)/python -m pip freeze --exclude-editable | grep -vE '^(pip|setuptools)=='; } > constraints.new
	@mv constraints.new constraints.txt

clean: ## remove everything made
	rm -rf $(VENV) demo .pytest_cache .mypy_cache .ruff_cache .import_linter_cache .hypothesis
