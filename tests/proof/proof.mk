# SPDX-License-Identifier: MIT
# Proofs by Frama-C that the arithmetic of src/ cannot overflow within its documented ranges; and what stands in for
# them where table reads rest on how planes are rounded.

PROVE = python3 tests/proof/prove.py --folder tests/proof --output $(BUILD)/proof --page docs/proofs.md

SUITE_reads := $(TEST_HARNESS) tests/proof/reads.c
$(eval $(call test_suite,sanitize,reads))

SUITES += test-prove
.PHONY: prove test-prove
prove: ## prove all kernels free of overflow, and write docs/proofs.md and what it was proven of beside it
	@$(PROVE)

test-prove: $(BUILD)/tests/sanitize/reads ## proofs of what has changed and of a sample (make prove: all), docs/proofs.md, and every table read of random triangles
	@$<
	@$(PROVE) --check --seed $(TEST_SEED)
