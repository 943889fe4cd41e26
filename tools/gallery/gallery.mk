# SPDX-License-Identifier: MIT
# The gallery: every example scene and variant, and what is measured in the pictures.

GALLERY_FIGURES := $(BUILD)/host/gallery-figures

$(eval $(call test_program,$(GALLERY_FIGURES),host,tools/gallery/figures.c tests/image/picture.c $(SCENE_SOURCES)))

.PHONY: gallery
gallery: $(HOST_PROGRAM) $(GALLERY_FIGURES) ## draw the example scenes into docs/gallery
	python3 tools/gallery/gallery.py $(HOST_PROGRAM) $(GALLERY_FIGURES) docs/modelled-instructions.csv docs/gallery

test-host-cli: $(GALLERY_FIGURES)
