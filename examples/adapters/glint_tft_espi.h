/* SPDX-License-Identifier: MIT */
/**
 * @file glint_tft_espi.h
 * Colour displays through TFT_eSPI, an Arduino library: glint_format_rgb565.
 */
#ifndef ADAPTER_TFT_ESPI_H
#define ADAPTER_TFT_ESPI_H

#include <TFT_eSPI.h>
#include <glint.h>

/** A display after begin() and setRotation(). */
glint_flush adapter_tft_espi_flush(TFT_eSPI &display);

#endif
