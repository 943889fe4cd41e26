# SPDX-License-Identifier: MIT
# After a changed pixel, or a changed instruction: everything that a test or lint compares, and all that pages show.

# In this order: what is measured, what is written from that, and the page, which holds both.
FIGURES := unit-tables chart-figures scaling gallery features options-page stability boards-page cost-pictures page-pictures \
    demo-picture proofs-page chart tile-tables web web-picture

.PHONY: figures demo-picture tile-tables
figures: ## after a changed pixel: measure, draw and write anew all that pages show and that tests compare
	@tools/setup.sh
	+@for step in $(FIGURES); do printf '######## %s\n' $$step; $(MAKE) --no-print-directory $$step || exit 1; done

demo-picture: $(HOST_PROGRAM)
	$(Q)$(HOST_PROGRAM) demo -o docs/demo.png

tile-tables:
	$(Q)python3 tools/bench/tiles.py --page docs/design.md --write docs/bench.csv docs/bench-arena.csv
