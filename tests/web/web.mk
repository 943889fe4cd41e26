# SPDX-License-Identifier: MIT
# The web page in a browser, against the host program.

SUITES += test-web
.PHONY: test-web

WEB_TEST := $(BUILD)/web/test

$(WEB_TEST)/node_modules/installed: tests/web/package.json tests/web/package-lock.json
	@mkdir -p $(WEB_TEST)
	$(Q)cp $^ $(WEB_TEST)
	$(Q)cd $(WEB_TEST) && npm ci --no-audit --no-fund --silent
	@touch $@

WEB_ERRORS := tests/web/errors.c port/web/measure.c tests/image/library_geometry.c tests/image/picture.c \
    tests/reference/reference.c tests/reference/lighting.c
$(WEB_TEST)/errors: $(WEB_ERRORS) port/web/measure.h $(filter-out %/main.o,$(HOST_OBJECTS)) $(SCENE_OBJECTS) $(BUILD)/host/libglint.a
	@mkdir -p $(@D)
	$(Q)$(CC) $(HOST_CFLAGS) -Iport/host -Iport/web -Iexamples -Itests/reference -Itests/image \
	    $(filter %.c %.o %.a,$^) $(SIMPLIFIER) -lm -o $@

test-web: $(WEB)/page/data.js $(WEB_TEST)/node_modules/installed $(WEB_TEST)/errors $(HOST_PROGRAM) $(PANEL_STREAM) ## the web page in a browser
	NODE_MODULES=$(abspath $(WEB_TEST)/node_modules) node tests/web/run.js $(WEB)/page docs/web $(WEB_TEST)

.PHONY: web-picture
web-picture: web $(WEB_TEST)/node_modules/installed
	NODE_MODULES=$(abspath $(WEB_TEST)/node_modules) node tests/web/picture.js docs/web/index.html docs/web.png
