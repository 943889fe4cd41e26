#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Finishes firmware for the RP2040: uf2.py checksum ELF, and uf2.py convert BIN UF2.

`checksum` writes the checksum of the second boot stage into the ELF file: CRC-32 with the polynomial 0x04c11db7, from
all ones, not reflected (RP2040 datasheet, chapter on the boot ROM). `convert` makes a file for the drive that the boot
ROM shows on a computer (USB Flashing Format, Microsoft).
"""
import struct
import sys

FLASH, BOOT_SIZE = 0x10000000, 256
FAMILY_RP2040 = 0xE48BFF56
BLOCK, PAYLOAD = 512, 256
MAGIC_1, MAGIC_2, MAGIC_END = 0x0A324655, 0x9E5D5157, 0x0AB16F30
FLAG_FAMILY = 0x2000


def checksum(data):
    crc = 0xFFFFFFFF
    for byte in data:
        crc ^= byte << 24
        for _ in range(8):
            crc = (crc << 1 ^ 0x04C11DB7 if crc & 0x80000000 else crc << 1) & 0xFFFFFFFF
    return crc


def file_offset(elf, address):
    """Where in an ELF file of 32 bits, little endian, the byte for `address` lies."""
    table, = struct.unpack_from("<I", elf, 28)
    size, count = struct.unpack_from("<HH", elf, 42)
    for i in range(count):
        kind, offset, _, physical, length = struct.unpack_from("<5I", elf, table + i * size)
        if kind == 1 and physical <= address < physical + length:
            return offset + address - physical
    raise SystemExit("nothing is loaded at 0x%x" % address)


def write_checksum(path):
    with open(path, "r+b") as file:
        elf = file.read()
        start = file_offset(elf, FLASH)
        code = elf[start:start + BOOT_SIZE - 4]
        if any(elf[start + BOOT_SIZE - 4:start + BOOT_SIZE]):
            raise SystemExit(path + ": the second boot stage leaves no room for its checksum")
        file.seek(start + BOOT_SIZE - 4)
        file.write(struct.pack("<I", checksum(code)))


def convert(source, target):
    with open(source, "rb") as file:
        data = file.read()
    pages = [data[at:at + PAYLOAD].ljust(PAYLOAD, b"\0") for at in range(0, len(data), PAYLOAD)]
    with open(target, "wb") as file:
        for number, page in enumerate(pages):
            head = struct.pack("<8I", MAGIC_1, MAGIC_2, FLAG_FAMILY, FLASH + number * PAYLOAD, PAYLOAD, number, len(pages),
                               FAMILY_RP2040)
            file.write((head + page).ljust(BLOCK - 4, b"\0") + struct.pack("<I", MAGIC_END))


def main(arguments):
    if len(arguments) == 2 and arguments[0] == "checksum":
        write_checksum(arguments[1])
    elif len(arguments) == 3 and arguments[0] == "convert":
        convert(*arguments[1:])
    else:
        raise SystemExit(__doc__)


if __name__ == "__main__":
    main(sys.argv[1:])
