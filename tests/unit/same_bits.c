/* SPDX-License-Identifier: MIT */
#include "checksummed.h"
#include "checksums.h"
#include "harness.h"
#include "unit.h"

/* A new entry without its checksum does not compile to a pass. */
void same_bits_on_every_core(void) {
    CHECK_EQUAL(checksummed_count, TEST_COUNT(expected_checksums));
    for (unsigned i = 0; i < checksummed_count && i < TEST_COUNT(expected_checksums); i++) {
        uint32_t checksum = checksummed_compute(i);
        if (!CHECK_EQUAL(checksum, expected_checksums[i])) {
            test_write("  of ");
            test_write(checksummed_name(i));
            test_write("\n");
        }
    }
}

/* What a core that stores high bytes first makes of RGB565 is what every core makes of RGB565 with high bytes first. */
void checksums_do_not_tell_byte_orders(void) {
    fixture *f = fixture_begin();
    CHECK_EQUAL(fixture_render(f), GLINT_OK);
    const uint32_t expected = fixture_checksum(f);
    f->config.format = &glint_format_rgb565_be;
    CHECK_EQUAL(fixture_render(f), GLINT_OK);
    CHECK_EQUAL(fixture_checksum_of_pairs(f), expected);
    CHECK(fixture_checksum(f) != expected);
}

/* All 16 sizes are compared on the host; here those whose buffers fit the smallest core, some with the least arena. */
void same_bits_for_every_tile_and_arena(void) {
    static const uint16_t sizes[][2] = {{16, 16}, {8, 8}, {16, 8}, {8, 32}, {8, 8}, {32, 16}};
    unsigned drawn = 0;
    for (uint32_t i = 0; i < CHECKSUMMED_PICTURES; i++) {
        uint32_t wanted = 0;
        for (unsigned size = 0; size < TEST_COUNT(sizes); size++) {
            fixture *const f = fixture_begin();
            checksummed_set_up(i, f);
            f->config.tile_width = sizes[size][0];
            f->config.tile_height = sizes[size][1];
            const glint_need need = fixture_need(f);
            if (need.least > FIXTURE_ARENA_BYTES)
                continue;
            if (size & 1)
                f->config.arena_size = need.least;
            CHECK_EQUAL(fixture_render(f), GLINT_OK);
            wanted = wanted ? wanted : fixture_checksum(f);
            CHECK_EQUAL(fixture_checksum(f), wanted);
            drawn++;
        }
    }
    CHECK(drawn >= 4 * CHECKSUMMED_PICTURES);
}
