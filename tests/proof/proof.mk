# SPDX-License-Identifier: MIT
# Proofs by Frama-C that the arithmetic of src/ cannot overflow within its documented ranges; and what stands in for
# them where table reads rest on how planes are rounded.

PROVE = python3 tests/proof/prove.py --folder tests/proof --output $(BUILD)/proof --page docs/proofs.md

SUITE_reads := $(TEST_HARNESS) tests/proof/reads.c
$(eval $(call test_suite,sanitize,reads))

SUITES += test-prove
.PHONY: prove test-prove
prove: ## prove the kernels free of overflow, and write docs/proofs.md
	@$(PROVE)

test-prove: $(BUILD)/tests/sanitize/reads ## the proofs, docs/proofs.md against them, and every table read of random triangles
	@$<
	@$(PROVE) --check
