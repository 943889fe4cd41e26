# SPDX-License-Identifier: MIT
# What others take: the library as one source and two headers, installed, and as an archive of the sources.

SINGLE := $(BUILD)/single
PUBLIC_HEADERS := $(wildcard src/*.h)

.PHONY: single install uninstall pack dist

single: $(SINGLE)/glint.c ## the library as one source and two headers, in build/single
$(SINGLE)/glint.c $(SINGLE)/glint.h $(SINGLE)/glint_extras.h &: tools/packages/single.py $(LIBRARY) $(wildcard src/*.h src/*/*.h)
	$(Q)python3 $< $(SINGLE)

# Below DESTDIR, as packagers want it, if that is set.
PREFIX   ?= /usr/local
INSTALL   = $(DESTDIR)$(PREFIX)
INSTALLED = $(INSTALL)/bin/glint $(INSTALL)/lib/libglint.a $(INSTALL)/lib/pkgconfig/glint.pc \
    $(PUBLIC_HEADERS:src/%=$(INSTALL)/include/%)

install: $(HOST_PROGRAM) $(BUILD)/host/libglint.a ## the glint program, library and headers to DESTDIR and PREFIX
	install -d $(sort $(dir $(INSTALLED)))
	install $(HOST_PROGRAM) $(INSTALL)/bin
	install -m 644 $(BUILD)/host/libglint.a $(INSTALL)/lib
	install -m 644 $(PUBLIC_HEADERS) $(INSTALL)/include
	sed -e 's|@PREFIX@|$(PREFIX)|' -e "s|@VERSION@|`tools/version.sh print`|" tools/packages/glint.pc.in > $(INSTALL)/lib/pkgconfig/glint.pc

uninstall: ## remove what install has put there
	rm -f $(INSTALLED)

pack: ## the library as a CMSIS-Pack, in build/pack
	@python3 tools/packages/pack.py $(BUILD)/pack `tools/version.sh print`

dist: ## the sources of the last commit as an archive, the same bytes anywhere, with its SHA256SUMS in build/dist
	@tools/packages/dist.sh $(BUILD)/dist
