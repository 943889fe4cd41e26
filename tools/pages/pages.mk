# SPDX-License-Identifier: MIT
# Pictures of docs/compose.md and docs/black.md.

PAGE_PICTURES := $(BUILD)/pages/pictures
$(PAGE_PICTURES): tools/pages/pictures.c $(wildcard examples/compose/*.c examples/compose/*.h examples/lines/*.c examples/lines/*.h) \
        $(addprefix port/host/,framebuffer.c png.c deflate.c output.c memory.c problem.c) $(BUILD)/host/libglint.a
	@mkdir -p $(@D)
	$(Q)$(CC) $(HOST_CFLAGS) -Iexamples -Iexamples/compose -Iport/host $(filter %.c %.a,$^) -lm -o $@

.PHONY: page-pictures
page-pictures: $(PAGE_PICTURES) ## draw the pictures of docs/compose.md and docs/black.md
	@mkdir -p docs/pages
	$< docs/pages

SUITES += test-pages
.PHONY: test-pages
test-pages: $(PAGE_PICTURES) ## the pictures of docs/compose.md and docs/black.md against what is drawn
	@rm -rf $(BUILD)/pages/drawn && mkdir -p $(BUILD)/pages/drawn
	@$< $(BUILD)/pages/drawn
	@python3 tools/cost/compare.py $(BUILD)/pages/drawn docs/pages docs/compose.md docs/black.md
