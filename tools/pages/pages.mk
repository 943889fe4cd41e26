# SPDX-License-Identifier: MIT
# Pictures of docs/compose.md, docs/black.md, docs/meshes.md and docs/view.md.

PAGE_PICTURES := $(BUILD)/pages/pictures
$(PAGE_PICTURES): tools/pages/pictures.c $(foreach folder,compose lines moving,$(wildcard examples/$(folder)/*.c examples/$(folder)/*.h)) \
        $(addprefix port/host/,framebuffer.c png.c deflate.c output.c memory.c problem.c) $(BUILD)/host/libglint.a
	@mkdir -p $(@D)
	$(Q)$(CC) $(HOST_CFLAGS) -Iexamples -Iexamples/compose -Iport/host $(filter %.c %.a,$^) -lm -o $@

WINDOW_PICTURE := $(BUILD)/pages/window
$(WINDOW_PICTURE): tools/pages/window.c $(VIEW_OBJECTS) $(VIEW_HOST)
	@mkdir -p $(@D)
	$(Q)$(CC) $(HOST_CFLAGS) $(HOST_INCLUDES) -Iport/host -Iport/host/window $^ $(SIMPLIFIER) -lm -o $@

.PHONY: page-pictures
page-pictures: $(PAGE_PICTURES) $(WINDOW_PICTURE)
	@mkdir -p docs/pages
	$(PAGE_PICTURES) docs/pages
	$(WINDOW_PICTURE) docs/pages

SUITES += test-pages
.PHONY: test-pages
test-pages: $(PAGE_PICTURES) $(WINDOW_PICTURE) ## the pictures of docs/compose.md, docs/black.md, docs/meshes.md and docs/view.md against what is drawn
	@rm -rf $(BUILD)/pages/drawn && mkdir -p $(BUILD)/pages/drawn
	@$(PAGE_PICTURES) $(BUILD)/pages/drawn
	@$(WINDOW_PICTURE) $(BUILD)/pages/drawn
	@python3 tools/cost/compare.py $(BUILD)/pages/drawn docs/pages docs/compose.md docs/black.md docs/meshes.md docs/view.md
