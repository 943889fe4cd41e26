# SPDX-License-Identifier: MIT
# Where methods fail: chosen regions and random scenes, docs/stability.md.

STABILITY_DIR     := tests/stability
STABILITY_CONTRACT := $(addprefix $(STABILITY_DIR)/,contract.c random_scene.c weights.c) tests/image/picture.c $(TEST_JUDGE)
STABILITY_REGIONS := $(addprefix $(STABILITY_DIR)/,region.c highlights.c normals.c powers.c lights.c triangles.c poses.c \
    screens.c inputs.c plain_raster.c) $(STABILITY_CONTRACT)

SUITE_stability_regions := $(TEST_HARNESS) $(STABILITY_DIR)/regions.c $(STABILITY_REGIONS)
SUITE_stability_kept    := $(TEST_HARNESS) $(STABILITY_DIR)/kept.c $(STABILITY_CONTRACT)
SUITE_stability_search  := $(STABILITY_DIR)/search.c $(STABILITY_CONTRACT)
SUITE_stability_table   := tests/harness.c $(STABILITY_DIR)/table.c $(STABILITY_REGIONS)

$(foreach suite,regions kept search table,$(eval $(call test_suite,host,stability_$(suite))))
$(eval $(call test_suite,sanitize,stability_search))

# A seed makes the same scene whoever compiles it.
STABILITY_CLANG := $(firstword $(filter clang-%,$(MATRIX_TESTED)))
$(eval $(call test_suite,$(STABILITY_CLANG),stability_kept))

# Scenes and the first one's seed; those of the figures in docs/stability.md.
SCENES ?= 100000
SEED   ?= 1

STABILITY_SEARCH = python3 $(STABILITY_DIR)/search.py

# The suite's own scenes, which are none of the figures', and as many as it has time for.
STABILITY_TEST_SEED := 1000001

$(BUILD)/stability/regions.md: $(BUILD)/tests/host/stability_table
	@mkdir -p $(@D)
	$(Q)$< > $@

.PHONY: stability test-stability
stability: $(BUILD)/stability/regions.md $(BUILD)/tests/host/stability_search ## where methods fail, by table and by SCENES random scenes from SEED: docs/stability.md
	@cat $<
	@$(STABILITY_SEARCH) $(BUILD)/tests/host/stability_search --scenes $(SCENES) --seed $(SEED) --csv docs/stability.csv --kept
	@python3 $(STABILITY_DIR)/page.py docs/stability.md $< docs/stability.csv

SUITES += test-stability
test-stability: $(BUILD)/stability/regions.md $(addprefix $(BUILD)/tests/host/stability_,regions kept search) \
        $(BUILD)/tests/$(STABILITY_CLANG)/stability_kept $(BUILD)/tests/sanitize/stability_search ## where methods fail: the library does not; 2,000 random scenes
	@status=0; \
	$(BUILD)/tests/host/stability_regions || status=1; \
	$(BUILD)/tests/host/stability_kept || status=1; \
	$(BUILD)/tests/$(STABILITY_CLANG)/stability_kept || status=1; \
	$(STABILITY_SEARCH) $(BUILD)/tests/host/stability_search --scenes 2000 --seed $(STABILITY_TEST_SEED) --test || status=1; \
	$(STABILITY_SEARCH) $(BUILD)/tests/sanitize/stability_search --scenes 500 --seed $(STABILITY_TEST_SEED) --test || status=1; \
	python3 $(STABILITY_DIR)/page.py docs/stability.md $< docs/stability.csv --check \
	    --program $(BUILD)/tests/host/stability_search || status=1; \
	exit $$status
