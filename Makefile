# SPDX-License-Identifier: MIT
# glint: see `make help`.

BUILD    := build
# The library compiles with all of these, so that it does in other builds too. Elsewhere fields left out of an initialiser
# are 0, which is what the optional ones of a scene mean.
LIBRARY_WARNINGS := -Wall -Wextra -Wpedantic -Wconversion -Wshadow -Werror
WARNINGS := $(LIBRARY_WARNINGS) -Wno-missing-field-initializers
CFLAGS   ?= -O2
# Lines, for reports and profiles. Debuggers show variables with DEBUG=-g, which takes a quarter of a compiler's time.
DEBUG    := -g1
LIBRARY  := $(wildcard src/*/*.c)
EXAMPLE_SCENES := $(wildcard examples/scenes/*.c)

# Commands are printed with V=1.
Q := $(if $(V),,@)

# What suites take samples of is chosen by the commit, or by a number that is given; EVERY=1 takes all.
TEST_SEED := $(or $(TEST_SEED),$(shell printf '%d' 0x$$(git rev-parse --short=7 HEAD 2>/dev/null || echo 1)))
EVERY     ?=

# $(call pick,bit,words): one of the words, or every one
pick = $(if $(EVERY),$2,$(word $(shell echo $$((($(TEST_SEED) >> $1) % $(words $2) + 1))),$2))

comma := ,
# $(call objects,folder,sources)
objects = $(patsubst %.c,$1/%.o,$2)

# Python leaves nothing beside its sources.
export PYTHONDONTWRITEBYTECODE := 1

.DELETE_ON_ERROR:
# Objects of suites stay.
.SECONDARY:
.PHONY: help
help: ## list what can be made
	@sed -n 's/^\([a-z][a-z-]*\):.*## \(.*\)/\1\t\2/p' $(filter-out %.d,$(MAKEFILE_LIST)) | sort | awk -F '\t' '{ printf "make %-19s %s\n", $$1, $$2 }'

# $(call library,folder,compiler and flags): <folder>/libglint.a, for programs of this machine
define library
$1/src/%.o: src/%.c Makefile
	@mkdir -p $$(@D)
	$$(Q)$2 -std=c99 $(LIBRARY_WARNINGS) $$(DEBUG) -Isrc -MMD -MP -c $$< -o $$@
$1/libglint.a: $(call objects,$1,$(LIBRARY))
	@rm -f $$@
	$$(Q)$(AR) rcs $$@ $$^
-include $$(wildcard $1/src/*/*.d)
endef

HOST_CFLAGS := -std=c99 $(WARNINGS) $(DEBUG) $(CFLAGS) -Isrc
$(eval $(call library,$(BUILD)/host,$(CC) $(CFLAGS) -ffreestanding))

include port/boards.mk port/host.mk port/web.mk tests/tests.mk tests/board.mk tests/fuzz.mk tools/tools.mk tools/coverage.mk

# Every suite that `make test` runs, each a phony target that closes with `N passed, N failed`: all that are called so but two,
# one of which is many suites, and the other takes minutes.
SUITES := $(filter-out test-quick test-board-animate-all,\
    $(shell sed -nE 's/^(test-[a-z-]+|fuzz-coverage):.* ## .*/\1/p' $(filter-out %.d,$(MAKEFILE_LIST))))

# While tools/test.sh runs them, each suite writes into a file of its own.
ifdef SUITE_LOGS
$(SUITES): private SHELL = tools/suite.sh
$(SUITES): private .SHELLFLAGS = $(SUITE_LOGS)/$@
.PHONY: $(SUITES:%=ended-%)
$(SUITES:%=ended-%): ended-%: %
	@echo 0 > $(SUITE_LOGS)/$*.status
endif

.PHONY: test test-quick lint clean $(SUITES)
test: ## run every suite, as many at once as there are cores; installs missing tools first
	@tools/setup.sh
	@tools/test.sh $(BUILD)/test $(SUITES)

test-quick: ## what most changes of src/ break, in two minutes: unit tests, images, formats and the README's program on a board
	@tools/test.sh $(BUILD)/test-quick test-unit-host test-image test-identity test-board-own-flush

lint: ## check format, static analysis, licence lines, version numbers and figures
	@tools/setup.sh
	@$(MAKE) --no-print-directory $(BUILD)/bench/bench_scenes.h $(BUILD)/bench/spot.h
	@TEST_SEED=$(TEST_SEED) EVERY=$(EVERY) tools/lint.sh $(BUILD)/lint

clean: ## remove everything that was built
	rm -rf $(BUILD)
