# SPDX-License-Identifier: MIT
# One prepared frame drawn by two threads at once, under ThreadSanitizer.

THREADS_SOURCES := tests/threads/threads.c $(TEST_HARNESS) $(TEST_SCENES)
THREAD_FLAGS    := -O1 -fsanitize=thread -pthread

SUITES += test-threads
.PHONY: test-threads

$(BUILD)/tests/threads/threads $(BUILD)/tests/threads/planted: $(THREADS_SOURCES) $(LIBRARY) $(TEST_HEADERS)
	@mkdir -p $(@D)
	$(Q)clang $(TEST_CFLAGS) $(THREAD_FLAGS) $(if $(filter %/planted,$@),-DSHARED_WORKSPACE) $(THREADS_SOURCES) $(LIBRARY) -lm -o $@

# The sanitizer must see it when two threads share what they must not.
test-threads: $(BUILD)/tests/threads/threads $(BUILD)/tests/threads/planted ## two callers draw the tiles of one frame, under ThreadSanitizer
	$(Q)TSAN_OPTIONS=halt_on_error=1:exitcode=66 $(BUILD)/tests/threads/threads
	$(Q)TSAN_OPTIONS=halt_on_error=1:exitcode=66 $(BUILD)/tests/threads/planted >$(BUILD)/tests/threads/planted.log 2>&1; \
	    if [ $$? -eq 66 ] && grep -q 'data race' $(BUILD)/tests/threads/planted.log; then echo '1 passed, 0 failed'; \
	    else echo 'a workspace shared by two threads was not reported'; echo '0 passed, 1 failed'; exit 1; fi
