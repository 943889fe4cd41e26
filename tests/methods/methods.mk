# SPDX-License-Identifier: MIT
# Candidate methods for cos^p and for unit vectors: what they are off by. tools/bench counts what they cost.

METHODS := tests/methods/methods.c $(patsubst %,tests/methods/%.c,power normalise)
METHODS_JUDGED := $(METHODS) tests/methods/judge.c
METHODS_HEADERS := $(wildcard tests/methods/*.h src/*.h src/*/*.h)

# The judge's doubles are the same from every compiler.
METHODS_CFLAGS := $(HOST_CFLAGS) -Itests -ffp-contract=off

$(BUILD)/methods/accuracy: tests/methods/accuracy.c $(METHODS_JUDGED) $(BUILD)/host/libglint.a $(METHODS_HEADERS)
	@mkdir -p $(@D)
	$(Q)$(CC) $(METHODS_CFLAGS) $(filter %.c %.a,$^) -lm -o $@

$(BUILD)/methods/test: tests/methods/test.c $(TEST_HARNESS) $(METHODS_JUDGED) $(BUILD)/host/libglint.a $(METHODS_HEADERS)
	@mkdir -p $(@D)
	$(Q)$(CC) $(METHODS_CFLAGS) $(filter %.c %.a,$^) -lm -o $@

SUITES += test-methods
.PHONY: test-methods accuracy
test-methods: $(BUILD)/methods/test ## every method's error is what it states, over samples
	@$<

# As many processes as cores, one method each.
$(BUILD)/accuracy.csv: $(BUILD)/methods/accuracy
	$(Q)rm -rf $(BUILD)/methods/rows && mkdir -p $(BUILD)/methods/rows
	$(Q)seq -w 0 $$(($$($<) - 1)) | xargs -P $$(nproc) -I {} sh -c '$< {} > $(BUILD)/methods/rows/{} || exit 255'
	$(Q){ $< header && cat $(BUILD)/methods/rows/*; } > $@

accuracy: $(BUILD)/accuracy.csv ## what every method is off by, over whole domains: minutes; writes docs/accuracy.csv
	@cut -d, -f 1-6,9 $< | column -s, -t
	cp $< docs/
