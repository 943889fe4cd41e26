/* SPDX-License-Identifier: MIT */
#include "glint_freertos.h"

void adapter_freertos_send(void *sender) {
    const adapter_freertos_sender *const s = sender;

    for (adapter_freertos_job job; xQueueReceive(s->queue, &job, portMAX_DELAY) == pdTRUE;) {
        int failed = s->panel.begin(s->panel.context, job.x, job.y, job.width, job.height, job.pixels, job.stride);

        if (!failed && s->panel.wait)
            failed = s->panel.wait(s->panel.context);
        job.from->failed = failed;
        xTaskNotifyGive(job.from->task);
    }
}

static int queue_tile(void *context, int x, int y, int width, int height, const void *pixels, size_t stride) {
    adapter_freertos_renderer *const from = context;
    const adapter_freertos_job job = {from, x, y, width, height, pixels, stride};

    return xQueueSend(from->sender->queue, &job, portMAX_DELAY) != pdTRUE;
}

static int wait_for_tile(void *context) {
    const adapter_freertos_renderer *const from = context;

    ulTaskNotifyTake(pdTRUE, portMAX_DELAY);
    return from->failed;
}

glint_flush adapter_freertos_flush(adapter_freertos_renderer *renderer) {
    return (glint_flush){queue_tile, wait_for_tile, renderer};
}
