# SPDX-License-Identifier: MIT
# Single changes to src/ and port/panel/ that some suite should notice. Not part of `make test`: to compile and time all
# suites takes minutes, a mutant seconds, a survivor a minute.

# How many are judged, in the order of a seed; files of src/ and port/panel/ that they are in, all unless some are named.
MUTANTS       ?= 20
MUTANTS_SEED  ?= 1
MUTANTS_FILES ?=
MUTANTS_JOBS  ?= $(shell nproc)

# What judges; which comes first follows from the time that they take, and from what they noticed before.
MUTANTS_SUITES := unit pixels stability_kept checked camera pick region callbacks lines extremes dark \
    coverage stability_regions orthographic layouts numbers kept arenas identity formats models accuracy patches
# Those of panels, each a program of its own.
MUTANTS_PANELS := pictures complaints faults i2c

# A suite's sources, with the harness that ends at the first failed check, and the judge of images that remembers.
mutants_sources = tools/mutants/harness.c $(patsubst tests/image/judge.c,tools/mutants/judge.c,$(filter-out $(TEST_HARNESS),$1))

mutants_run = python3 tools/mutants/mutants.py --build $(BUILD)/mutants --known tools/mutants/known.csv --count $(MUTANTS) \
    --seed $(MUTANTS_SEED) --jobs $(MUTANTS_JOBS) --compiler "$(CC)" --flags "-std=c99 $(TEST_INCLUDES) -Itests/panel" \
    $(foreach suite,$(MUTANTS_SUITES),--suite "$(suite)=$(call mutants_sources,$(SUITE_$(suite)))") \
    $(foreach suite,$(MUTANTS_PANELS),--suite "panel_$(suite)=$(call mutants_sources,tests/panel/$(suite).c $(PANEL_SHARED))")

.PHONY: mutants
mutants: ## change MUTANTS places of src/ and port/panel/, one at a time, from MUTANTS_SEED (MUTANTS_FILES: only there): does a suite notice?
	@$(mutants_run) --files $(MUTANTS_FILES)
