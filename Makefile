# Two commands for a newcomer: `make reproduce` and `make test`. Both do their own set-up.
PYTHON ?= python3
VENV := .venv
BIN := $(VENV)/bin
CORES := $(shell getconf _NPROCESSORS_ONLN)

.PHONY: reproduce test web nightly lowest metadata bench docs dist clean

reproduce: $(VENV)/ready
	$(BIN)/haptonic reproduce studies/touchpad.toml --out results/touchpad-report --workers $(CORES) --overwrite

# Compiled modules are kept even where the machine keeps none: each start of Python then takes 1 s and not 3 s.
test: $(VENV)/ready-test
	$(BIN)/ruff check .
	$(BIN)/ruff format --check .
	$(BIN)/mypy
	PYTHONDONTWRITEBYTECODE= OMP_NUM_THREADS=1 $(BIN)/pytest -n $(CORES) --dist worksteal -m "not nightly"

# The programs of the interactive pages, from web/ into the package; only for changes of web/, and with Node.
web: web/node_modules/ready
	cd web && npm run --silent check && npm run --silent build

# The gallery's cells run as in the documentation, with what it needs. A run that was stopped goes on where it
# ended, unless another commit is checked out or a file is changed. Tests that need up to 16 GB run one at a time.
NIGHT = .nightly-$(shell git rev-parse --short HEAD)
nightly: $(VENV)/ready-test $(VENV)/ready-docs
	git diff --quiet HEAD || rm -f $(NIGHT)
	OMP_NUM_THREADS=1 $(BIN)/pytest -n $(CORES) --dist loadfile -m "nightly or hypothesis" --hypothesis-profile=anew \
		--continued $(NIGHT)

# A selection of the tests with the oldest packages that pyproject.toml allows; the pages of the reference are written
# with the newest, so their test is left out.
lowest: $(VENV)/ready-dist
	$(BIN)/uv venv --quiet --clear --python $(BIN)/python .venv-lowest
	$(BIN)/uv pip install --quiet --python .venv-lowest/bin/python --resolution lowest-direct --editable ".[test,fast]"
	OMP_NUM_THREADS=1 .venv-lowest/bin/python -m pytest -n $(CORES) -o filterwarnings=default \
		-m "not nightly" $(filter-out tests/test_reference.py,$(wildcard tests/test_*.py)) tests/channels tests/study tests/plots \
		tests/core/test_bands.py tests/core/test_solvers.py tests/cli/test_answers.py tests/cli/test_compare.py tests/cli/test_start.py tests/cli/test_help.py \
		tests/friction/test_statistics.py tests/friction/test_recordings.py

# Citation file and settings of the repository, by two programs of others in an environment of their own.
metadata:
	test -x .venv-metadata/bin/repo-review || $(PYTHON) -m venv .venv-metadata
	.venv-metadata/bin/python -m pip install --quiet --disable-pip-version-check cffconvert "sp-repo-review[cli]"
	.venv-metadata/bin/cffconvert --validate
	.venv-metadata/bin/repo-review .

# One script per claim; docs/benchmarks.md shows what they measured, with the kernels that OpenBLAS chooses itself.
bench: $(VENV)/ready-test
	cd benchmarks && for claim in diagram_in_a_second any_cell_in_seconds sweeps_in_twenty_seconds thousand_times_cheaper \
		cost_growth estimates_hold wavevectors_everywhere mirror_in_thirty_seconds search_finds_what_is_there plate_in_half_a_minute \
		plate_growth rows_keep_it_there hundred_thousand_trials trials_tell_the_truth scan_twin gap_in_the_scan \
		fit_covers_the_truth pages_answer_at_once drag_answers_at_once hour_of_the_studio render; \
		do env -u OPENBLAS_CORETYPE -u OPENBLAS_L2_SIZE ../$(BIN)/python $$claim.py || exit 1; done

# The pages of docs/ as a site, docs/_build/html; any warning is an error, and nothing is fetched.
docs: $(VENV)/ready-docs
	$(BIN)/python docs/write_reference.py
	$(BIN)/python -m sphinx -W --keep-going -q -b html docs docs/_build/html

# dist/: sdist and wheel, tried in a clean environment of every Python here; licences and bill of materials of all that an
# installation brings.
dist: $(VENV)/ready-dist
	rm -rf dist
	$(BIN)/python -m build --outdir dist
	$(BIN)/python -m twine check --strict dist/*.whl dist/*.tar.gz
	$(BIN)/python release/prove.py dist

$(VENV)/ready-dist: $(VENV)/ready
	$(BIN)/python -m pip install --quiet --disable-pip-version-check --editable ".[dist]"
	touch $@

$(VENV)/ready-docs: $(VENV)/ready
	$(BIN)/python -m pip install --quiet --disable-pip-version-check --editable ".[docs]"
	touch $@

$(VENV)/ready: pyproject.toml
	test -x $(BIN)/python || $(PYTHON) -m venv $(VENV)
	$(BIN)/python -m pip install --quiet --disable-pip-version-check --editable ".[fast]"
	touch $@

$(VENV)/ready-test: $(VENV)/ready $(if $(shell command -v npm),web/node_modules/ready)
	$(BIN)/python -m pip install --quiet --disable-pip-version-check --editable ".[test,cad,ngsolve]"
	touch $@

web/node_modules/ready: web/package.json web/package-lock.json
	cd web && npm ci --silent --ignore-scripts
	touch $@

clean:
	rm -rf $(VENV) web/node_modules .venv-lowest .venv-metadata dist results docs/_build
