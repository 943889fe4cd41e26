# SPDX-License-Identifier: MIT
# Pictures of nodes, and of how pixels are lit, from what the library does on the host.

NODES_PROGRAM := $(BUILD)/host/nodes
NODES_PICTURES := nodes.svg ways.svg

$(NODES_PROGRAM): $(patsubst %.c,$(BUILD)/host/%.o,tools/nodes/nodes.c tests/image/picture.c $(SCENE_SOURCES)) \
        $(addprefix $(BUILD)/host/port/,counts.o watch.o framebuffer.o memory.o) $(BUILD)/host/libglint.a
	@mkdir -p $(@D)
	$(Q)$(VARIANT_host) $(HOST_WATCH) $^ -lm -o $@

.PHONY: nodes test-nodes
nodes: $(NODES_PROGRAM) ## draw where nodes lie, and how pixels are lit, into docs/charts
	$(foreach picture,$(NODES_PICTURES),$(NODES_PROGRAM) $(picture) > docs/charts/$(picture) &&) true

SUITES += test-nodes
test-nodes: $(NODES_PROGRAM) ## pictures of nodes against those that the library gives
	@mkdir -p $(BUILD)/nodes
	@passed=0; failed=0; for picture in $(NODES_PICTURES); do \
	    if $(NODES_PROGRAM) $$picture > $(BUILD)/nodes/$$picture && cmp $(BUILD)/nodes/$$picture docs/charts/$$picture; \
	    then passed=$$((passed + 1)); else failed=$$((failed + 1)); echo "docs/charts/$$picture: make nodes"; fi; done; \
	    echo "$$passed passed, $$failed failed"; test $$failed = 0
