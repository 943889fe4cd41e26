/* SPDX-License-Identifier: MIT */
/**
 * @file glint_freertos.h
 * Renderers in tasks of FreeRTOS that share one panel: a task of its own sends the tiles that the others queue, so that
 * a renderer goes on with its next tile meanwhile.
 */
#ifndef ADAPTER_FREERTOS_H
#define ADAPTER_FREERTOS_H

#include <FreeRTOS.h>
#include <glint.h>
#include <queue.h>
#include <task.h>

/** The sender; all of it set before its task starts. */
typedef struct adapter_freertos_sender {
    QueueHandle_t queue; /**< Of adapter_freertos_job, one entry a renderer. */
    glint_flush panel;   /**< What really sends: a panel's flush, with its DMA. */
} adapter_freertos_sender;

/** A renderer's side; as many as there are tasks that draw. */
typedef struct adapter_freertos_renderer {
    const adapter_freertos_sender *sender;
    TaskHandle_t task; /**< That calls glint_render; its notification 0 is in use. */
    int failed;        /**< What the panel's flush returned for the last tile. */
} adapter_freertos_renderer;

/** A tile on its way. */
typedef struct adapter_freertos_job {
    adapter_freertos_renderer *from;
    int x, y, width, height;
    const void *pixels;
    size_t stride;
} adapter_freertos_job;

/** The sender's task, with an adapter_freertos_sender as its parameter; never returns. */
void adapter_freertos_send(void *sender);

/** A renderer's flush; `renderer` must outlive it. */
glint_flush adapter_freertos_flush(adapter_freertos_renderer *renderer);

#endif
