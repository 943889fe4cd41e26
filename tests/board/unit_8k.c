/* SPDX-License-Identifier: MIT */
/*
 * The unit tests that 8 KB of RAM have room for: those that draw no picture, for the screen and the arena of
 * tests/unit/fixture.h take 11 KB. Numbers are the same bits there as anywhere.
 */
#include "harness.h"
#include "unit/checksums.h"
#include "unit/domains.h"
#include "unit/fixture.h"
#include "unit/unit.h"

/* As many arguments as in tests/unit/checksummed.c, whose pictures come first. */
#define DOMAIN_ARGUMENTS 4096

/* What those tests want of the fixture: room for generated meshes, and checksums. */
uint8_t *fixture_arena(void) {
    static uint8_t bytes[1536];

    return bytes;
}

uint32_t fixture_checksum_add(uint32_t checksum, const uint8_t *bytes, size_t count) {
    for (size_t i = 0; i < count; i++) {
        checksum = (checksum ^ bytes[i]) * 16777619u;
    }
    return checksum;
}

static void numbers_are_the_same_bits(void) {
    const uint32_t *expected = expected_checksums + TEST_COUNT(expected_checksums) - DOMAIN_COUNT;

    for (unsigned i = 0; i < DOMAIN_COUNT; i++) {
        CHECK_EQUAL(domain_checksum(&domains[i], DOMAIN_ARGUMENTS), expected[i]);
    }
}

static int is_among(const char *name, const test_case *cases, unsigned count) {
    for (unsigned i = 0; i < count; i++) {
        const char *a = name, *b = cases[i].name;
        while (*a && *a == *b) {
            a++, b++;
        }
        if (*a == *b) {
            return 1;
        }
    }
    return 0;
}

int test_main(test_writer write) {
#define UNIT_NAME(name) #name,
    static const char *const all[] = {UNIT_CASES(UNIT_NAME)};
    static const test_case cases[] = {
        TEST_CASE(status_sentences),
        TEST_CASE(row_bytes),
        TEST_CASE(generators_fill_their_room),
        TEST_CASE(generators_face_outwards),
        TEST_CASE(generators_follow_their_formulas),
        TEST_CASE(generators_refuse_bad_input),
        TEST_CASE(numbers_are_the_same_bits),
    };

    for (unsigned i = 0; i < TEST_COUNT(all); i++) {
        if (!is_among(all[i], cases, TEST_COUNT(cases))) {
            write("not run here: ");
            write(all[i]);
            write("\n");
        }
    }
    return test_run(write, cases, TEST_COUNT(cases));
}
