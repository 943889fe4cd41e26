/* SPDX-License-Identifier: MIT */
/* Suite: the models complain of what the controllers forbid, each of each thing, and of nothing else. */
#include "harness.h"
#include "panel_model.h"

#include <stdio.h>
#include <string.h>

/*
 * A stream in short: bytes in hexadecimal go with D/C low, after a '+' high up to the end of the word; rN is a reset of
 * N microseconds, R holds it, mN are milliseconds that pass, kN is the clock in kHz.
 */
static const char *take_word(panel_model *model, const char *word) {
    const char *end = strchr(word, ' ');
    const char *at = word + 1;
    const size_t length = end != NULL ? (size_t)(end - word) : strlen(word);
    unsigned value = 0;
    int is_data = word[0] == '+';

    if (word[0] == 'R') {
        panel_model_reset(model, 1);
    } else if (word[0] == 'r' && sscanf(at, "%u", &value) == 1) {
        panel_model_reset(model, 1);
        panel_model_delay(model, (uint64_t)value * 1000);
        panel_model_reset(model, 0);
    } else if (word[0] == 'm' && sscanf(at, "%u", &value) == 1) {
        panel_model_delay(model, (uint64_t)value * 1000000);
    } else if (word[0] == 'k' && sscanf(at, "%u", &value) == 1) {
        panel_model_clock(model, value * 1000);
    } else {
        for (at = word + is_data; at < word + length && sscanf(at, "%2x", &value) == 1; at += 2) {
            (is_data ? panel_model_data : panel_model_command)(model, (uint8_t)value);
        }
    }
    return word + length + (end != NULL);
}

static void take(panel_model *model, const char *stream) {
    while (*stream != '\0') {
        stream = take_word(model, stream);
    }
    panel_model_finish(model);
}

/* What a stream makes a new module complain of: one bit for each complaint. */
static unsigned complaints_of(const char *module, const char *stream) {
    panel_model *model = panel_model_begin(module);
    unsigned seen = 0;

    if (!CHECK(model != NULL)) {
        return 0;
    }
    take(model, stream);
    for (int i = 0; i < PANEL_COMPLAINT_COUNT; i++) {
        seen |= panel_model_complaints(model, (panel_complaint)i) > 0 ? 1u << i : 0u;
    }
    panel_model_end(model);
    return seen;
}

#define NOTHING 0u
#define ONLY(complaint) (1u << PANEL_COMPLAINT_##complaint)

typedef struct provocation {
    const char *stream;
    unsigned complaints;
} provocation;

static void provoke(const char *module, const provocation *list, unsigned count) {
    for (unsigned i = 0; i < count; i++) {
        if (!CHECK_EQUAL(complaints_of(module, list[i].stream), list[i].complaints)) {
            test_write(module);
            test_write(": ");
            test_write(list[i].stream);
            test_write("\n");
        }
    }
}

/* ---- Display command set ---------------------------------------------------------------------------------------- */

#define AWAKE "m120 11 m5 "
#define SMALL "2a +00000001 2b +00000000 "

static void display_command_set(void) {
    static const char *const modules[] = {"ili9341",      "st7789-240x240", "st7789-240x320", "st7789-135x240",
                                          "st7735-green", "st7735-red",     "st7735-black",   "gc9a01"};
    static const provocation list[] = {
        {AWAKE "3a +55 36 +00 " SMALL "2c +12345678 29", NOTHING},
        {AWAKE "3a +55 " SMALL "2c +1234567812", NOTHING}, /* half a pixel too many is none */
        {AWAKE "3a +55 " SMALL "2c +123456781234", ONLY(OVERRUN)},
        {AWAKE "3a +66 " SMALL "2c +123456123456", NOTHING},
        {AWAKE "3a +66 " SMALL "2c +123456123456123456", ONLY(OVERRUN)},
        {AWAKE "02", ONLY(COMMAND)},
        {AWAKE "3a", ONLY(PARAMETERS)},
        {AWAKE "3a 29", ONLY(PARAMETERS)},
        {AWAKE "3a +5555", ONLY(PARAMETERS)},
        {AWAKE "2a +000000 2b +00000000", ONLY(PARAMETERS)},
        {AWAKE "29 +00", ONLY(PARAMETERS)},
        {AWAKE "3a +51", ONLY(VALUE)},
        {"m5 +00", ONLY(DATA)},
        {"m5 3a +55 2c", ONLY(ASLEEP)},
        {"m5 29", ONLY(DISPLAY)},
        {AWAKE "2a +00010000 2c", ONLY(WINDOW)},
        {AWAKE "2a +000000f0 2b +00000000 2c +00", ONLY(WINDOW)},
        {AWAKE "2b +00000140 2c", ONLY(WINDOW)},
        {AWAKE "36 +20 2b +000000f0 2c", ONLY(WINDOW)},
        {"m4 36 +00", ONLY(DELAY)},
        {"m119 11", ONLY(DELAY)},
        {AWAKE "m114 10", ONLY(DELAY)},
        {AWAKE "m115 10 m5 36 +00", NOTHING},
        {AWAKE "m115 10 m119 11", ONLY(DELAY)},
        {AWAKE "m115 10 m120 11", NOTHING},
        {"m120 11 m4 29", ONLY(DELAY)},
        {AWAKE "01 m4 36 +00", ONLY(DELAY)},
        {AWAKE "01 m119 11", ONLY(DELAY)},
        {AWAKE "01 m120 11 m5 29", NOTHING},
        {"r9 m120 11", ONLY(RESET)},
        {"r10 m120 11", NOTHING},
        {"r10 m119 11", ONLY(DELAY)},
        {"r10 m4 00", ONLY(DELAY)},
        {"R 00", ONLY(RESET)},
    };

    for (unsigned i = 0; i < TEST_COUNT(modules); i++) {
        provoke(modules[i], list, TEST_COUNT(list));
    }
}

static void memories_end_where_they_end(void) {
    static const provocation small[] = {
        {AWAKE "2a +0000007f 2b +0000009f 2c", NOTHING},
        {AWAKE "2a +00000080 2b +00000000 2c", ONLY(WINDOW)},
        {AWAKE "2b +000000a0 2a +00000000 2c", ONLY(WINDOW)},
    };
    static const provocation large[] = {
        {AWAKE "2a +00000083 2b +000000a1 2c", NOTHING},
        {AWAKE "2a +00000084 2b +00000000 2c", ONLY(WINDOW)},
        {AWAKE "2b +000000a2 2a +00000000 2c", ONLY(WINDOW)},
    };

    provoke("st7735-black", small, TEST_COUNT(small));
    provoke("st7735-green", large, TEST_COUNT(large));
}

static void twelve_bits_where_there_are(void) {
    static const provocation without[] = {{AWAKE "3a +33", ONLY(VALUE)}};
    static const provocation with[] = {
        {AWAKE "3a +33 " SMALL "2c +123456", NOTHING},
        {AWAKE "3a +33 " SMALL "2c +12345678", NOTHING},
        {AWAKE "3a +33 " SMALL "2c +1234567812", ONLY(OVERRUN)},
    };

    provoke("ili9341", without, TEST_COUNT(without));
    provoke("st7789-240x240", with, TEST_COUNT(with));
    provoke("st7735-red", with, TEST_COUNT(with));
    provoke("gc9a01", with, TEST_COUNT(with));
}

/* On a serial bus, pixels of 18 bits only. */
static void three_bytes_where_there_is_no_less(void) {
    static const provocation list[] = {
        {AWAKE "3a +66 2a +0000013f 2b +000001df 2c +123456", NOTHING},
        {AWAKE "3a +66 " SMALL "2c +123456123456123456", ONLY(OVERRUN)},
        {AWAKE "3a +55", ONLY(VALUE)},
        {AWAKE "3a +33", ONLY(VALUE)},
        {AWAKE "2a +00000140 2b +00000000 2c", ONLY(WINDOW)},
        {AWAKE "2b +000001e0 2a +00000000 2c", ONLY(WINDOW)},
    };

    provoke("ili9488", list, TEST_COUNT(list));
}

static void own_registers_are_locked(void) {
    static const provocation list[] = {
        {AWAKE "fe ef f0 +450908082629", NOTHING},        {AWAKE "f0 +450908082629", ONLY(LOCKED)},
        {AWAKE "ef f0 +450908082629", ONLY(LOCKED)},      {AWAKE "fe 00 ef 85 +ff", ONLY(LOCKED)},
        {AWAKE "fe ef f0 +4509080826", ONLY(PARAMETERS)},
    };

    provoke("gc9a01", list, TEST_COUNT(list));
}

static void clocks_have_a_limit(void) {
    static const struct {
        const char *module, *slow, *fast;
    } list[] = {
        {"ili9341", "k10000 " AWAKE "29", "k10001 " AWAKE "29"},
        {"st7789-240x240", "k15000 " AWAKE "29", "k15200 " AWAKE "29"},
        {"st7735-green", "k15000 " AWAKE "29", "k15200 " AWAKE "29"},
        {"gc9a01", "k100000 " AWAKE "29", "k100001 " AWAKE "29"},
        {"ssd0323", "m1 k4000 e3", "m1 k4001 e3"},
        {"ssd1306", "m1 k10000 e3", "m1 k10001 e3"},
        {"ssd1351", "m1 k4500 e3", "m1 k4600 e3"},
        {"ili9488", "k15000 " AWAKE "29", "k15200 " AWAKE "29"},
        {"sh1106", "m1 k4000 e3", "m1 k4001 e3"},
        {"ssd0303", "m1 k4000 e3", "m1 k4001 e3"},
        {"st7567", "m1 k4000 e3", "m1 k4001 e3"},
    };

    for (unsigned i = 0; i < TEST_COUNT(list); i++) {
        CHECK_EQUAL(complaints_of(list[i].module, list[i].slow), NOTHING);
        CHECK_EQUAL(complaints_of(list[i].module, list[i].fast), ONLY(CLOCK));
    }
}

/* Bytes take time: a frame of 153,600 of 8 clocks at 10 MHz takes 122.9 ms, more than what sleep has to wait for. */
static void bytes_take_time(void) {
    for (uint32_t clock = 0; clock <= 10000000; clock += 10000000) {
        panel_model *model = panel_model_begin("ili9341");
        take(model, AWAKE "3a +55 2a +000000ef 2b +0000013f");
        panel_model_clock(model, clock);
        take(model, "2c");
        for (int i = 0; i < 240 * 320 * 2; i++) {
            panel_model_data(model, 0);
        }
        take(model, "10");
        CHECK_EQUAL(panel_model_complaints(model, PANEL_COMPLAINT_DELAY), clock == 0);
        panel_model_end(model);
    }
}

/* ---- Solomon ---------------------------------------------------------------------------------------------------- */

static void ssd1306(void) {
    static const provocation list[] = {
        {"m1 ae 8d14 2000 af 210001 220000 +0102", NOTHING},
        {"m1 2000 210001 220000 +010203", ONLY(OVERRUN)},
        {"m1 2001 210000 220001 +0102", NOTHING},
        {"m1 2001 210000 220001 +010203", ONLY(OVERRUN)},
        {"m1 b0 00 10 +0102", NOTHING},
        {"m1 82", ONLY(COMMAND)},
        {"m1 2000 21", ONLY(PARAMETERS)},
        {"m1 2000 2100 +00", ONLY(PARAMETERS)},
        {"m1 2003", ONLY(VALUE)},
        {"m1 a80e", ONLY(VALUE)},
        {"m1 d340", ONLY(VALUE)},
        {"m1 8d00", ONLY(VALUE)},
        {"m1 2000 b1", ONLY(VALUE)},
        {"m1 af", ONLY(DISPLAY)},
        {"m1 8d10 af", ONLY(DISPLAY)},
        {"m1 2000 210180", ONLY(WINDOW)},
        {"m1 2000 210100", ONLY(WINDOW)},
        {"m1 2000 220008", ONLY(WINDOW)},
        {"m1 2002 210001", ONLY(WINDOW)},
        {"m1 da02", ONLY(WIRING)},
        {"ae", ONLY(DELAY)},
        {"r2 m1 ae", ONLY(RESET)},
        {"r3 m1 ae", NOTHING},
        {"r3 ae", ONLY(DELAY)},
        {"R ae", ONLY(RESET)},
    };

    provoke("ssd1306", list, TEST_COUNT(list));
}

/* Places that commands of page mode set beyond the window, in other modes: counting stays in the memory. */
static void ssd1306_counts_within_its_memory(void) {
    static const char *const places[] = {"m1 2000 210001 220707 05", "m1 2001 21007f 220001 b5"};

    for (unsigned i = 0; i < TEST_COUNT(places); i++) {
        panel_model *model = panel_model_begin("ssd1306");
        take(model, places[i]);
        for (int j = 0; j < 200; j++) {
            panel_model_data(model, 0);
        }
        CHECK_EQUAL(panel_model_complaints(model, PANEL_COMPLAINT_VALUE), 1);
        panel_model_end(model);
    }
}

/* What all of them do that are addressed page by page. */
static void pages(void) {
    static const char *const modules[] = {"sh1106", "ssd0303", "st7567"};
    static const provocation list[] = {
        {"m1 ae b0 02 10 +0102 40 a1 c8 a5 a4 a7 a6 e3", NOTHING},
        {"m1 b7 03 18 +01", NOTHING},
        {"m1 b7 03 18 +0102", ONLY(OVERRUN)},
        {"m1 b7 04 18 +01", ONLY(WINDOW)},
        {"m1 b9", ONLY(COMMAND)},
        {"m1 99", ONLY(COMMAND)},
        {"m1 81", ONLY(PARAMETERS)},
        {"m1 81 +00", ONLY(PARAMETERS)},
        {"ae", ONLY(DELAY)},
        {"r9 m1 ae", ONLY(RESET)},
        {"r10 m1 ae", NOTHING},
        {"r10 ae", ONLY(DELAY)},
        {"R ae", ONLY(RESET)},
    };
    static const provocation leds[] = {
        {"m1 b8", ONLY(COMMAND)}, {"m1 28", ONLY(COMMAND)}, {"m1 a80e", ONLY(VALUE)},
        {"m1 d340", ONLY(VALUE)}, {"m1 ad00", ONLY(VALUE)},
    };
    static const provocation oled[] = {{"m1 a80f af", ONLY(WIRING)},
                                       {"m1 32 ad8b af", NOTHING},
                                       {"m1 ad8a af", ONLY(DISPLAY)},
                                       {"m1 da02 af", ONLY(WIRING)}};
    static const provocation strip[] = {{"m1 a80f ad8b af", NOTHING},
                                        {"m1 32", ONLY(COMMAND)},
                                        {"m1 a83f af", ONLY(WIRING)},
                                        {"m1 a80f ad8a af", ONLY(DISPLAY)}};
    static const provocation lcd[] = {{"m1 b8 2f af", NOTHING},    {"m1 af", ONLY(DISPLAY)},
                                      {"m1 2e af", ONLY(DISPLAY)}, {"m1 2f e2 af", ONLY(DISPLAY)},
                                      {"m1 8140", ONLY(VALUE)},    {"m1 f802", ONLY(VALUE)}};

    for (unsigned i = 0; i < TEST_COUNT(modules); i++) {
        provoke(modules[i], list, TEST_COUNT(list));
    }
    provoke("sh1106", leds, TEST_COUNT(leds));
    provoke("ssd0303", leds, TEST_COUNT(leds));
    provoke("sh1106", oled, TEST_COUNT(oled));
    provoke("ssd0303", strip, TEST_COUNT(strip));
    provoke("st7567", lcd, TEST_COUNT(lcd));
}

static void ssd0323(void) {
    static const provocation list[] = {
        {"m1 a052 a24c a83f ad03 af 150001 750000 +1234", NOTHING},
        {"m1 150001 750000 +123456", ONLY(OVERRUN)},
        {"m1 20", ONLY(COMMAND)},
        {"m1 1500", ONLY(PARAMETERS)},
        {"m1 b801020304050607", ONLY(PARAMETERS)},
        {"m1 a052 a24c a83f af", ONLY(DISPLAY)},
        {"m1 a042 a24c a83f ad03 af", ONLY(WIRING)},
        {"m1 a052 a200 a83f ad03 af", ONLY(WIRING)},
        {"m1 150040", ONLY(WINDOW)},
        {"m1 150100", ONLY(WINDOW)},
        {"m1 750050", ONLY(WINDOW)},
        {"ae", ONLY(DELAY)},
        {"r2 m1 ae", ONLY(RESET)},
        {"R ae", ONLY(RESET)},
    };

    provoke("ssd0323", list, TEST_COUNT(list));
}

static void ssd1351(void) {
    static const provocation list[] = {
        {"m1 fd +12 fd +b1 a0 +64 15 +0001 75 +0000 5c +12345678 af", NOTHING},
        {"m1 15 +0001 75 +0000 5c +123456781234", ONLY(OVERRUN)},
        {"m1 20", ONLY(COMMAND)},
        {"m1 15 +00", ONLY(PARAMETERS)},
        {"m1 15 +000000", ONLY(PARAMETERS)},
        {"m1 +00", ONLY(DATA)},
        {"m1 a0 +24", ONLY(VALUE)},
        {"m1 ca +0e", ONLY(VALUE)},
        {"m1 fd +00", ONLY(VALUE)},
        {"m1 a0 +44", ONLY(WIRING)},
        {"m1 15 +0080", ONLY(WINDOW)},
        {"m1 15 +0100", ONLY(WINDOW)},
        {"m1 75 +0080", ONLY(WINDOW)},
        {"m1 a2 +00", ONLY(LOCKED)},
        {"m1 fd +b1 a2 +00 fd +b0 a2 +00", ONLY(LOCKED)},
        {"m1 fd +16 15 +0001", ONLY(LOCKED)},
        {"m1 fd +16 fd +12 15 +0001", NOTHING},
        {"ae", ONLY(DELAY)},
        {"r1 m1 ae", ONLY(RESET)},
        {"R ae", ONLY(RESET)},
    };

    provoke("ssd1351", list, TEST_COUNT(list));
}

/* ---- What is seen ----------------------------------------------------------------------------------------------- */

static int is_dark(panel_model *model) {
    const panel_picture *picture = panel_model_picture(model);
    int sum = 0;

    for (int i = 0; i < picture->width * picture->height * 3; i++) {
        sum |= picture->rgb[i];
    }
    return sum == 0;
}

/* Nothing before the display is on, nothing once it is off, asleep or in reset. */
static void dark_unless_it_is_on(void) {
    panel_model *model = panel_model_begin("st7789-240x240");

    take(model, AWAKE);
    CHECK(is_dark(model));
    take(model, "29");
    CHECK(!is_dark(model));
    take(model, "28");
    CHECK(is_dark(model));
    take(model, "29 m120 10");
    CHECK(is_dark(model));
    take(model, "m120 11 m5");
    CHECK(!is_dark(model));
    take(model, "R");
    CHECK(is_dark(model));
    panel_model_end(model);
}

/* One pixel of the glass after a stream. */
static uint32_t corner(const char *module, const char *stream) {
    panel_model *model = panel_model_begin(module);
    const uint8_t *rgb;
    uint32_t colour;

    take(model, stream);
    rgb = panel_model_picture(model)->rgb;
    colour = (uint32_t)rgb[0] << 16 | (uint32_t)rgb[1] << 8 | rgb[2];
    panel_model_end(model);
    return colour;
}

#define WRITE_RED "3a +55 2a +000000ef 2b +00000000 2c +f800 29"

/* The first pixel, as a colour: mirrors, the order of colours and inversion belong to the glass and to the registers.
 */
static void colours_and_inversion(void) {
    CHECK_EQUAL(corner("st7789-240x240", AWAKE "21 " WRITE_RED), 0xff0000);
    CHECK_EQUAL(corner("st7789-240x240", AWAKE WRITE_RED), 0x00ffff);
    CHECK_EQUAL(corner("st7789-240x240", AWAKE "21 20 " WRITE_RED), 0x00ffff);
    CHECK_EQUAL(corner("st7789-240x240", AWAKE "21 36 +08 " WRITE_RED), 0x0000ff);
    CHECK_EQUAL(corner("ili9341", AWAKE "36 +48 " WRITE_RED), 0xff0000);
    CHECK_EQUAL(corner("ili9341", AWAKE "36 +40 " WRITE_RED), 0x0000ff);
    CHECK_EQUAL(corner("ssd1351", "m1 a0 +74 15 +007f 75 +007f 5c +f800 af"), 0xff0000);
    CHECK_EQUAL(corner("ssd1351", "m1 a0 +70 15 +007f 75 +007f 5c +f800 af"), 0x0000ff);
    CHECK_EQUAL(corner("ssd1351", "m1 a0 +74 15 +007f 75 +007f 5c +f800 af a7"), 0x00ffff);
    CHECK_EQUAL(corner("ssd1351", "m1 a0 +74 15 +007f 75 +007f 5c +f800 af a4"), 0);
    CHECK_EQUAL(corner("ssd1306", "m1 8d14 2000 a1 c8 21007f 220007 +01 af"), 0xffffff);
    CHECK_EQUAL(corner("ssd1306", "m1 8d14 2000 a1 c8 21007f 220007 +fe af"), 0);
    CHECK_EQUAL(corner("ssd1306", "m1 8d14 2000 a1 c8 21007f 220007 +fe af a7"), 0xffffff);
    CHECK_EQUAL(corner("ssd1306", "m1 8d14 2000 a1 c8 41 21007f 220007 +02 af"), 0xffffff);
    CHECK_EQUAL(corner("ssd0323", "m1 a052 a24c a83f ad03 15003f 75004f +f0 af"), 0xffffff);
    CHECK_EQUAL(corner("sh1106", "m1 a1 c8 b0 02 10 +01 af"), 0xffffff);
    CHECK_EQUAL(corner("sh1106", "m1 a1 c8 b0 02 10 +fe af"), 0);
    CHECK_EQUAL(corner("sh1106", "m1 a0 c8 b0 01 18 +01 af"), 0xffffff);
    CHECK_EQUAL(corner("sh1106", "m1 a1 c0 b7 02 10 +80 af"), 0xffffff);
    CHECK_EQUAL(corner("sh1106", "m1 a1 c8 41 b0 02 10 +02 af"), 0xffffff);
    CHECK_EQUAL(corner("ssd0303", "m1 a80f a1 c8 b0 04 12 +01 af"), 0xffffff);
    CHECK_EQUAL(corner("ssd0303", "m1 a80f a0 c0 b1 0f 15 +80 af"), 0xffffff);
    CHECK_EQUAL(corner("st7567", "m1 2f a0 c8 b0 00 10 +01 af"), 0);
    CHECK_EQUAL(corner("st7567", "m1 2f a0 c8 b0 00 10 +fe af"), 0xffffff);
    CHECK_EQUAL(corner("st7567", "m1 2f a0 c8 b0 00 10 +01 a7 af"), 0xffffff);
    CHECK_EQUAL(corner("ili9488", AWAKE "36 +48 3a +66 2a +0000013f 2b +00000000 2c +fc0000 29"), 0xff0000);
    CHECK_EQUAL(corner("ssd0323", "m1 a052 a24c a83f ad03 15003f 75004f +5f af"), 0x555555);
    CHECK_EQUAL(corner("gc9a01", AWAKE "21 " WRITE_RED), 0); /* a round glass has no corner */
}

/* Complaints are noted in order with their place. */
static void notes_tell_where(void) {
    panel_model *model = panel_model_begin("ili9341");
    panel_note notes[PANEL_NOTES_MAX];

    take(model, "m120 11 02 m5");
    for (int i = 0; i < 100; i++) {
        take(model, "03");
    }
    CHECK_EQUAL(panel_model_notes(model, notes), PANEL_NOTES_MAX);
    CHECK_EQUAL(notes[0].complaint, PANEL_COMPLAINT_COMMAND);
    CHECK_EQUAL(notes[0].byte, 2);
    CHECK_EQUAL(notes[0].command, 2);
    CHECK_EQUAL(notes[1].complaint, PANEL_COMPLAINT_DELAY);
    CHECK_EQUAL(notes[2].byte, 3);
    CHECK_EQUAL(panel_model_all_complaints(model), 102);
    CHECK(panel_model_begin("none") == NULL);
    panel_model_end(model);
}

int test_main(test_writer write) {
    static const test_case cases[] = {
        TEST_CASE(display_command_set),
        TEST_CASE(memories_end_where_they_end),
        TEST_CASE(twelve_bits_where_there_are),
        TEST_CASE(three_bytes_where_there_is_no_less),
        TEST_CASE(own_registers_are_locked),
        TEST_CASE(clocks_have_a_limit),
        TEST_CASE(bytes_take_time),
        TEST_CASE(ssd1306),
        TEST_CASE(ssd1306_counts_within_its_memory),
        TEST_CASE(pages),
        TEST_CASE(ssd0323),
        TEST_CASE(ssd1351),
        TEST_CASE(dark_unless_it_is_on),
        TEST_CASE(colours_and_inversion),
        TEST_CASE(notes_tell_where),
    };

    return test_run(write, cases, TEST_COUNT(cases));
}
