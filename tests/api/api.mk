# SPDX-License-Identifier: MIT
# The public interface: headers by every compiler and language, what names they bring, what older versions' users wrote,
# and arguments beyond what functions take.

SUITE_old := $(TEST_HARNESS) tests/api/old.c
SUITE_limits := $(TEST_HARNESS) tests/api/limits.c
SUITE_helpers := $(TEST_HARNESS) tests/api/helpers.c
$(foreach suite,old limits helpers,$(eval $(call test_suite,host,$(suite))))

# By each compiler with every warning but the one of fields that are left out.
OLD_WARNINGS := -std=c99 -Wall -Wextra -Wpedantic -Wconversion -Wshadow -Werror -Wno-missing-field-initializers

API_MESH := $(BUILD)/api/teapot.h
$(API_MESH): $(HOST_PROGRAM) examples/models/teapot.obj
	@mkdir -p $(@D)
	$(Q)$(HOST_PROGRAM) convert examples/models/teapot.obj -o $@

SUITES += test-api
.PHONY: test-api
API_PANELS := $(patsubst %.c,$(BUILD)/host/%.o,$(wildcard port/panel/*.c))

test-api: $(addprefix $(BUILD)/tests/host/,old limits helpers) $(API_MESH) $(BUILD)/host/libglint.a $(API_PANELS) ## headers as C and C++, their names, and what older versions' users wrote
	@$<; status=$$?; $(BUILD)/tests/host/limits || status=1; $(BUILD)/tests/host/helpers || status=1; \
	for compiler in gcc clang; do \
	    $$compiler $(OLD_WARNINGS) $(TEST_INCLUDES) -fsyntax-only tests/api/old.c || status=1; \
	done; \
	python3 tests/api/headers.py --mesh $(API_MESH) --library $(BUILD)/host/libglint.a \
	    --panels $(API_PANELS) || status=1; exit $$status
