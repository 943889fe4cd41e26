/* SPDX-License-Identifier: MIT */
/** @file faults.h What breaks on a board's bus, each board in its own way (faults_<board>.c). */
#ifndef GLINT_FAULTS_H
#define GLINT_FAULTS_H

#include "panel/panel.h"

typedef enum fault_kind {
    FAULT_NONE,    /**< Whatever was broken works again. */
    FAULT_STOPPED, /**< The bus takes no more bytes: it never falls idle. */
    FAULT_SLOW,    /**< What is being sent takes far longer than it can need. */
    FAULT_BROKEN,  /**< The transfer ends with an error. */
    FAULT_RESET    /**< The core is reset, and the panel is not told. */
} fault_kind;

/** The board's panel, on a bus that faults_set can break. */
extern const glint_panel faults_panel;

/** Called between two tiles, while nothing is on its way. */
void faults_set(fault_kind kind);

#endif
