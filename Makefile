# Two commands for a newcomer: `make reproduce` and `make test`. Both do their own set-up.
PYTHON ?= python3
VENV := .venv
BIN := $(VENV)/bin
CORES := $(shell getconf _NPROCESSORS_ONLN)

.PHONY: reproduce test nightly bench docs clean

reproduce: $(VENV)/ready
	$(BIN)/haptonic reproduce studies/touchpad.toml --out results/touchpad-report --workers $(CORES) --overwrite

test: $(VENV)/ready-test
	$(BIN)/ruff check .
	$(BIN)/ruff format --check .
	$(BIN)/mypy
	OMP_NUM_THREADS=1 $(BIN)/pytest -n $(CORES) --dist worksteal -m "not nightly"

nightly: $(VENV)/ready-test
	OMP_NUM_THREADS=$(CORES) $(BIN)/pytest -m nightly --hypothesis-profile=anew

# One script per claim; docs/benchmarks.md shows what they measured, with the kernels that OpenBLAS chooses itself.
bench: $(VENV)/ready-test
	cd benchmarks && for claim in diagram_in_a_second sweeps_in_twenty_seconds thousand_times_cheaper \
		cost_growth estimates_hold mirror_in_thirty_seconds search_finds_what_is_there plate_in_half_a_minute \
		plate_growth rows_keep_it_there hundred_thousand_trials trials_tell_the_truth scan_twin gap_in_the_scan \
		fit_covers_the_truth render; \
		do env -u OPENBLAS_CORETYPE -u OPENBLAS_L2_SIZE ../$(BIN)/python $$claim.py || exit 1; done

# The pages of docs/ as a site, docs/_build/html; any warning is an error, and nothing is fetched.
docs: $(VENV)/ready-docs
	$(BIN)/python docs/write_reference.py
	$(BIN)/python -m sphinx -W --keep-going -q -b html docs docs/_build/html

$(VENV)/ready-docs: $(VENV)/ready
	$(BIN)/python -m pip install --quiet --disable-pip-version-check --editable ".[docs]"
	touch $@

$(VENV)/ready: pyproject.toml
	test -x $(BIN)/python || $(PYTHON) -m venv $(VENV)
	$(BIN)/python -m pip install --quiet --disable-pip-version-check --editable .
	touch $@

$(VENV)/ready-test: $(VENV)/ready
	$(BIN)/python -m pip install --quiet --disable-pip-version-check --editable ".[test,cad,ngsolve]"
	touch $@

clean:
	rm -rf $(VENV) results docs/_build
