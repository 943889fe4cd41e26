# SPDX-License-Identifier: MIT
# One prepared frame drawn by two threads at once, under ThreadSanitizer.

THREADS_SHARED := $(TEST_HARNESS) $(TEST_SCENES)

SUITES += test-threads
.PHONY: test-threads

$(eval $(call test_variant,threads,clang -O1 -fsanitize=thread -pthread))
$(foreach program,threads planted,\
    $(eval $(call test_program,$(BUILD)/tests/threads/$(program),threads,tests/threads/$(program).c $(THREADS_SHARED))))
$(BUILD)/threads/tests/threads/planted.o: tests/threads/threads.c
	@mkdir -p $(@D)
	$(Q)$(VARIANT_threads) $(TEST_CFLAGS) -DSHARED_WORKSPACE -MMD -MP -c $< -o $@

# The sanitizer must see it when two threads share what they must not.
test-threads: $(BUILD)/tests/threads/threads $(BUILD)/tests/threads/planted ## two callers draw the tiles of one frame, under ThreadSanitizer
	$(Q)TSAN_OPTIONS=halt_on_error=1:exitcode=66 $(BUILD)/tests/threads/threads
	$(Q)TSAN_OPTIONS=halt_on_error=1:exitcode=66 $(BUILD)/tests/threads/planted >$(BUILD)/tests/threads/planted.log 2>&1; \
	    if [ $$? -eq 66 ] && grep -q 'data race' $(BUILD)/tests/threads/planted.log; then echo '1 passed, 0 failed'; \
	    else echo 'a workspace shared by two threads was not reported'; echo '0 passed, 1 failed'; exit 1; fi
