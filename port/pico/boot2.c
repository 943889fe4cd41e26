/* SPDX-License-Identifier: MIT */
/*
 * Second boot stage: the first 256 bytes of flash, which the boot ROM copies to RAM and starts when their checksum is
 * right (tools/uf2.py writes it). Lets the core read flash in place, by the plain read command that every SPI flash
 * knows, and starts the program behind itself. Registers of the flash interface (SSI) from the RP2040 datasheet.
 */
__attribute__((naked, used, section(".boot2"))) void pico_boot2(void);

void pico_boot2(void) {
    __asm__ volatile(".syntax unified\n"
                     "push {lr}\n"
                     "ldr r3, =0x18000000\n" /* SSI */
                     "movs r0, #0\n"
                     "str r0, [r3, #0x08]\n" /* off while it is set up */
                     "movs r0, #4\n"
                     "str r0, [r3, #0x14]\n" /* a quarter of the core's clock */
                     "ldr r0, =0x001f0300\n" /* frames of 32 bits on one wire; send an address, read data */
                     "str r0, [r3, #0x00]\n"
                     "ldr r1, =0x03000218\n" /* command 03h, 8 bits; address, 24 bits */
                     "adds r3, #0xf0\n"
                     "str r1, [r3, #0x04]\n"
                     "subs r3, #0xf0\n"
                     "movs r0, #0\n"
                     "str r0, [r3, #0x04]\n" /* one frame a read */
                     "movs r0, #1\n"
                     "str r0, [r3, #0x08]\n"
                     "pop {r0}\n"
                     "cmp r0, #0\n"
                     "beq 1f\n" /* called by the boot ROM */
                     "bx r0\n"
                     "1: ldr r0, =0x10000100\n" /* the program's vectors */
                     "ldr r1, =0xe000ed08\n"
                     "str r0, [r1]\n"
                     "ldmia r0!, {r1, r2}\n"
                     "msr msp, r1\n"
                     "bx r2\n"
                     ".ltorg\n");
}
