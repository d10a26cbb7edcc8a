# make run: the app on the embedded demo data.  make test: lint and every test.
VENV := .venv
PYTHON ?= python3
BIN := $(VENV)/bin
PORT ?= 8050
WORKSPACE ?= workspace
# tests in as many processes as there are cores (four at most); a file's tests stay together, the browser's go first
TOGETHER ?= -n logical --maxprocesses 4 --dist loadfile --no-loadscope-reorder

.PHONY: run test lint bench clean slow browser

run: $(VENV)/.installed
	$(BIN)/motionscape serve $(WORKSPACE) --demo --port $(PORT)

test: $(VENV)/.installed-dev browser lint
	$(BIN)/python -m pytest $(TOGETHER)

slow: $(VENV)/.installed-dev browser
	$(BIN)/python -m pytest -m slow

lint: $(VENV)/.installed-dev
	$(BIN)/ruff check .
	$(BIN)/ruff format --check .
	$(BIN)/lint-imports
	$(BIN)/python scripts/check_docstrings.py core

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

clean:
	rm -rf $(VENV) build dist .pytest_cache .ruff_cache .hypothesis .import_linter_cache
	find . -name __pycache__ -type d -prune -exec rm -rf {} +
