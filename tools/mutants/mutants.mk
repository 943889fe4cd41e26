# SPDX-License-Identifier: MIT
# Single changes to src/ that some suite should notice. Not part of `make test`: a mutant takes seconds, a survivor minutes.

# How many are judged, in the order of a seed; files of src/ that they are in, all unless some are named.
MUTANTS       ?= 20
MUTANTS_SEED  ?= 1
MUTANTS_FILES ?=
MUTANTS_JOBS  ?= $(shell nproc)

# In this order, up to the first that fails: those that notice much in little time first.
MUTANTS_SUITES := unit stability_kept changes output extremes highlights fill_rule kept drops stability_regions numbers setup point budget \
    accuracy models compare identity

.PHONY: mutants
mutants: ## change MUTANTS places of src/, one at a time, from MUTANTS_SEED (MUTANTS_FILES: only there): does a suite notice?
	@python3 tools/mutants/mutants.py --build $(BUILD)/mutants --known tools/mutants/known.csv --count $(MUTANTS) \
	    --seed $(MUTANTS_SEED) --jobs $(MUTANTS_JOBS) --compiler "$(CC)" --flags "-std=c99 $(TEST_INCLUDES)" \
	    $(foreach suite,$(MUTANTS_SUITES),--suite "$(suite)=$(SUITE_$(suite))") --files $(MUTANTS_FILES)
