# SPDX-License-Identifier: MIT
# Functions of one argument over their whole domains, against double precision.

DOMAINS         := $(BUILD)/tests/domain/domains
DOMAINS_SOURCES := tests/domain/domains.c tests/unit/domains.c tests/unit/fixture.c tests/harness.c

$(eval $(call test_program,$(DOMAINS),host,$(DOMAINS_SOURCES)))

SUITES += test-domains
.PHONY: domains test-domains
test-domains: $(DOMAINS) ## functions of one argument: small domains and edges whole, others in strides; make domains is all
	@echo "from arguments that TEST_SEED=$(TEST_SEED) chooses"
	@$< 101 $(TEST_SEED)

domains: $(DOMAINS) ## every argument of every function of one argument, up to 2^32 each: about an hour
	@$< names | xargs -P 2 -I NAME nice $< 1 0 NAME
