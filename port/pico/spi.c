/* SPDX-License-Identifier: MIT */
/*
 * SPI0 (Arm PL022) to the panel: D/C GP16, chip select GP17, clock GP18, data GP19, backlight GP20, reset GP21.
 *
 * Pixels go by DMA while the core draws on. One channel moves the bytes of a row; when it is done it starts another,
 * which writes the next row's count and address into it out of a list in RAM, and so sets it going again. A row of no
 * bytes at address 0 ends the list. No interrupt is used.
 */
#include "spi.h"

#include "board.h"
#include "cortex-m/cortex-m.h"
#include "glint.h"
#include "rp2040.h"

enum { PIN_DATA = 16, PIN_SELECT = 17, PIN_CLOCK = 18, PIN_OUT = 19, PIN_BACKLIGHT = 20, PIN_RESET = 21 };

enum {
    IO_CONTROL = 0x40014004, /* of pin 0; 8 bytes a pin */
    FUNCTION_SPI = 1,
    FUNCTION_SIO = 5,
};

#define SIO_OUT_SET 0xd0000014u
#define SIO_OUT_CLEAR 0xd0000018u
#define SIO_ENABLE_SET 0xd0000024u

enum {
    SPI = 0x4003c000,
    SPI_CONTROL_0 = SPI + 0x00,
    SPI_CONTROL_1 = SPI + 0x04,
    SPI_DATA = SPI + 0x08,
    SPI_STATUS = SPI + 0x0c,
    SPI_PRESCALE = SPI + 0x10,
    SPI_INTERRUPT_CLEAR = SPI + 0x20,
    SPI_DMA = SPI + 0x24,
    CONTROL_0_8_BIT_MODE_0 = 7u, /* Motorola frames of 8 bits, clock idles low, sampled on its first edge */
    CONTROL_1_ENABLE = 1u << 1,
    STATUS_TX_NOT_FULL = 1u << 1,
    STATUS_RX_NOT_EMPTY = 1u << 2,
    STATUS_BUSY = 1u << 4,
    OVERRUN = 1u << 0, /* what comes back is not read while DMA sends */
    DMA_TRANSMIT = 1u << 1,
};

enum {
    DMA_ROW = 0x50000000, /* channel 0 */
    DMA_LIST = 0x50000040,
    DMA_READ = 0x00,
    DMA_WRITE = 0x04,
    DMA_COUNT = 0x08,
    DMA_CONTROL_TRIGGER = 0x0c,
    DMA_ALIAS_1_CONTROL = 0x10,
    DMA_ALIAS_3_COUNT = 0x38, /* followed by the read address, which triggers unless it is 0 */
    DMA_ABORT = 0x50000444,
    DMA_ENABLE = 1u << 0,
    DMA_WORDS = 2u << 2,
    DMA_READ_ON = 1u << 4,
    DMA_WRITE_ON = 1u << 5,
    DMA_RING_8_BYTES = 3u << 6,
    DMA_RING_WRITE = 1u << 10,
    DMA_CHAIN_SHIFT = 11,
    DMA_PACE_SHIFT = 15,
    DMA_PACE_SPI0_OUT = 16,
    DMA_PACE_NONE = 63,
    DMA_QUIET = 1u << 21,
    DMA_BUSY = 1u << 24,
};
#define DMA_ERRORS_CLEAR (3u << 29) /* by writing them */
#define DMA_FAULTS (7u << 29)

/*
 * A byte takes 8 bits / 62.5 MHz, 16 clocks of the core, and a full FIFO 128. A poll takes at least 5, and at least 15
 * while DMA sends: waits give up after some 20 times what they can need.
 */
enum { BYTE_POLLS = 64, BUSY_POLLS = 512, DMA_BYTE_POLLS = 16 };

/** A row for the list: as the registers at DMA_ALIAS_3_COUNT lie. */
typedef struct dma_row {
    uint32_t count;
    const uint8_t *bytes;
} dma_row;

/** The list, for the tallest tile, and its end. */
static dma_row rows[64 + 1];

/** Polls that what `begin` started may take. */
static uint32_t patience;

static void set_pin(unsigned pin, int high) {
    *cortex_m_register(high ? SIO_OUT_SET : SIO_OUT_CLEAR) = 1u << pin;
}

static void use_pin(unsigned pin, uint32_t function) {
    *cortex_m_register(IO_CONTROL + 8 * pin) = function;
}

void pico_spi_start(uint32_t core_hz, uint32_t bus_hz) {
    const uint32_t prescale = ((core_hz + bus_hz - 1) / bus_hz + 1) & ~1u; /* even, rounded up: never too fast */

    rp2040_release(RP2040_RESET_IO | RP2040_RESET_PADS | RP2040_RESET_SPI0 | RP2040_RESET_DMA);
    for (unsigned pin = PIN_DATA; pin <= PIN_RESET; pin++) {
        if (pin == PIN_CLOCK || pin == PIN_OUT) {
            use_pin(pin, FUNCTION_SPI);
            continue;
        }
        set_pin(pin, pin != PIN_BACKLIGHT);
        *cortex_m_register(SIO_ENABLE_SET) = 1u << pin;
        use_pin(pin, FUNCTION_SIO);
    }
    *cortex_m_register(SPI_CONTROL_1) = 0;
    *cortex_m_register(SPI_PRESCALE) = prescale;
    *cortex_m_register(SPI_CONTROL_0) = CONTROL_0_8_BIT_MODE_0;
    *cortex_m_register(SPI_DMA) = DMA_TRANSMIT;
    *cortex_m_register(SPI_CONTROL_1) = CONTROL_1_ENABLE;
}

static void drain(void) {
    for (int i = 0; i < 8 && (*cortex_m_register(SPI_STATUS) & STATUS_RX_NOT_EMPTY); i++) {
        (void)*cortex_m_register(SPI_DATA);
    }
    *cortex_m_register(SPI_INTERRUPT_CLEAR) = OVERRUN;
}

static glint_status wait_until_idle(void) {
    uint32_t polls = BUSY_POLLS;

    while ((*cortex_m_register(SPI_STATUS) & STATUS_BUSY) && --polls) {
    }
    drain();
    return polls ? GLINT_OK : GLINT_ERROR_TIMEOUT;
}

/* What a transfer that was given up left behind leaves before the panel listens. */
static glint_status select(int is_data) {
    const glint_status status = wait_until_idle();

    if (!status) {
        set_pin(PIN_DATA, is_data);
        set_pin(PIN_SELECT, 0);
    }
    return status;
}

/* Sees the last byte out, then lets the panel go. */
static glint_status finish(glint_status status) {
    const glint_status last = wait_until_idle();

    set_pin(PIN_SELECT, 1);
    return status ? status : last;
}

static glint_status push(const uint8_t *bytes, size_t count) {
    for (size_t i = 0; i < count; i++) {
        uint32_t polls = BYTE_POLLS;
        while ((*cortex_m_register(SPI_STATUS) & STATUS_TX_NOT_FULL) == 0) {
            if (--polls == 0) {
                return GLINT_ERROR_TIMEOUT;
            }
        }
        *cortex_m_register(SPI_DATA) = bytes[i];
    }
    return GLINT_OK;
}

static glint_status send(int is_data, const uint8_t *bytes, size_t count) {
    const glint_status status = select(is_data);

    return status ? status : finish(push(bytes, count));
}

static glint_status command(void *context, const uint8_t *bytes, size_t count) {
    (void)context;
    return send(0, bytes, count);
}

static glint_status data(void *context, const uint8_t *bytes, size_t count) {
    (void)context;
    return send(1, bytes, count);
}

static void dma(uintptr_t channel, uintptr_t offset, uintptr_t value) {
    *cortex_m_register(channel + offset) = (uint32_t)value;
}

static void list_rows(const uint8_t *bytes, size_t row_bytes, size_t row_count, size_t stride) {
    if (row_bytes == stride) { /* one long row */
        row_bytes *= row_count;
        row_count = 1;
    }
    for (size_t i = 0; i < row_count; i++) {
        rows[i] = (dma_row){(uint32_t)row_bytes, bytes + i * stride};
    }
    rows[row_count] = (dma_row){0, 0};
    patience = (uint32_t)(row_bytes * row_count) * DMA_BYTE_POLLS + BUSY_POLLS;
}

static glint_status begin(void *context, const uint8_t *bytes, size_t row_bytes, size_t row_count, size_t stride) {
    (void)context;
    if (row_count == 0 || row_count >= sizeof rows / sizeof rows[0]) {
        return GLINT_ERROR_BUS;
    }
    const glint_status status = select(1);
    if (status) {
        return status;
    }
    list_rows(bytes, row_bytes, row_count, stride);
    dma(DMA_ROW, DMA_WRITE, SPI_DATA);
    dma(DMA_ROW, DMA_ALIAS_1_CONTROL,
        DMA_ERRORS_CLEAR | DMA_ENABLE | DMA_READ_ON | 1u << DMA_CHAIN_SHIFT |
            (uint32_t)DMA_PACE_SPI0_OUT << DMA_PACE_SHIFT | DMA_QUIET);
    dma(DMA_LIST, DMA_READ, (uintptr_t)rows);
    dma(DMA_LIST, DMA_WRITE, DMA_ROW + DMA_ALIAS_3_COUNT);
    dma(DMA_LIST, DMA_COUNT, 2);
    dma(DMA_LIST, DMA_CONTROL_TRIGGER,
        DMA_ENABLE | DMA_WORDS | DMA_READ_ON | DMA_WRITE_ON | DMA_RING_8_BYTES | DMA_RING_WRITE |
            1u << DMA_CHAIN_SHIFT | (uint32_t)DMA_PACE_NONE << DMA_PACE_SHIFT | DMA_QUIET);
    return GLINT_OK;
}

/* Has the list been read to its end, and are both channels done? */
static int is_sent(void) {
    const dma_row *next = (const dma_row *)(uintptr_t)*cortex_m_register(DMA_LIST + DMA_READ);
    const uint32_t busy =
        *cortex_m_register(DMA_LIST + DMA_ALIAS_1_CONTROL) | *cortex_m_register(DMA_ROW + DMA_ALIAS_1_CONTROL);

    return next > rows && next[-1].bytes == 0 && (busy & DMA_BUSY) == 0;
}

static int has_failed(void) {
    return (*cortex_m_register(DMA_ROW + DMA_ALIAS_1_CONTROL) & DMA_FAULTS) != 0;
}

static glint_status wait(void *context) {
    glint_status status = GLINT_OK;

    (void)context;
    while (!is_sent() && !has_failed() && --patience) { /* a channel that has failed stands still */
    }
    if (has_failed()) {
        status = GLINT_ERROR_BUS;
    } else if (patience == 0) {
        status = GLINT_ERROR_TIMEOUT;
    }
    if (status) {
        *cortex_m_register(DMA_ABORT) = 3;
    }
    return finish(status);
}

static void reset(void *context, int active) {
    (void)context;
    set_pin(PIN_RESET, !active);
}

static void backlight(void *context, int on) {
    (void)context;
    set_pin(PIN_BACKLIGHT, on);
}

static void delay(void *context, uint32_t milliseconds) {
    (void)context;
    board_delay(milliseconds);
}

const glint_bus pico_spi_bus = {.command = command,
                                .data = data,
                                .begin = begin,
                                .wait = wait,
                                .reset = reset,
                                .backlight = backlight,
                                .delay = delay};
