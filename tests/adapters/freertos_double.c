/* SPDX-License-Identifier: MIT */
/* Tasks, a queue and notifications of FreeRTOS by threads. */
#include "adapters.h"

#include <adapters/glint_freertos.h>
#include <pthread.h>
#include <string.h>

enum { RENDERERS = 2 };

static pthread_mutex_t lock = PTHREAD_MUTEX_INITIALIZER;
static pthread_cond_t changed = PTHREAD_COND_INITIALIZER;

struct QueueDefinition {
    adapter_freertos_job jobs[RENDERERS];
    unsigned count, taken;
    int is_closed;
};

struct tskTaskControlBlock {
    uint32_t notifications;
};

static __thread TaskHandle_t current;

BaseType_t xQueueSend(QueueHandle_t queue, const void *item, TickType_t ticks) {
    (void)ticks;
    pthread_mutex_lock(&lock);
    while (queue->count - queue->taken == RENDERERS)
        pthread_cond_wait(&changed, &lock);
    memcpy(&queue->jobs[queue->count++ % RENDERERS], item, sizeof queue->jobs[0]);
    pthread_cond_broadcast(&changed);
    pthread_mutex_unlock(&lock);
    return pdTRUE;
}

BaseType_t xQueueReceive(QueueHandle_t queue, void *item, TickType_t ticks) {
    BaseType_t got = 0;

    (void)ticks;
    pthread_mutex_lock(&lock);
    while (queue->count == queue->taken && !queue->is_closed)
        pthread_cond_wait(&changed, &lock);
    if (queue->count != queue->taken) {
        memcpy(item, &queue->jobs[queue->taken++ % RENDERERS], sizeof queue->jobs[0]);
        got = pdTRUE;
    }
    pthread_cond_broadcast(&changed);
    pthread_mutex_unlock(&lock);
    return got;
}

BaseType_t xTaskNotifyGive(TaskHandle_t task) {
    pthread_mutex_lock(&lock);
    task->notifications++;
    pthread_cond_broadcast(&changed);
    pthread_mutex_unlock(&lock);
    return pdTRUE;
}

uint32_t ulTaskNotifyTake(BaseType_t clear, TickType_t ticks) {
    (void)clear, (void)ticks;
    pthread_mutex_lock(&lock);
    while (!current->notifications)
        pthread_cond_wait(&changed, &lock);
    const uint32_t count = current->notifications;
    current->notifications = 0;
    pthread_mutex_unlock(&lock);
    return count;
}

/* Two screens side by side: the second renderer's tiles lie right of the first one's. */
typedef struct panel {
    adapted_memory halves[RENDERERS];
    int waits;
} panel;

static int begin_on_panel(void *context, int x, int y, int width, int height, const void *pixels, size_t stride) {
    panel *const p = context;
    const glint_flush half = adapted_flush(&p->halves[x >= ADAPTED_WIDTH]);

    return half.begin(half.context, x % ADAPTED_WIDTH, y, width, height, pixels, stride);
}

static int wait_for_panel(void *context) {
    panel *const p = context;

    p->waits++;
    return 0;
}

typedef struct drawing {
    glint_config config;
    struct tskTaskControlBlock task;
    adapter_freertos_renderer renderer;
    glint_status status;
    int flush_error;
} drawing;

static void *draw(void *context) {
    drawing *const d = context;
    glint_renderer renderer;

    current = &d->task;
    d->status = glint_init(&renderer, &d->config);
    for (int frame = 0; frame < 3 && d->status == GLINT_OK; frame++)
        d->status = glint_render(&renderer, adapted_scene());
    d->flush_error = renderer.stats.flush_error;
    return 0;
}

static void *run_sender(void *sender) {
    adapter_freertos_send(sender);
    return 0;
}

static uint8_t screens[RENDERERS][ADAPTED_BYTES];
static drawing drawings[RENDERERS];

/* Both draw three frames; that number `refused` is refused its fifth tile, -1 for none. */
static panel draw_both(int refused) {
    struct QueueDefinition queue = {.is_closed = 0};
    panel p = {{{&glint_format_rgb565, screens[0], 0, 0}, {&glint_format_rgb565, screens[1], 0, 0}}, 0};
    adapter_freertos_sender sender = {&queue, {begin_on_panel, wait_for_panel, &p}};
    pthread_t threads[RENDERERS + 1];

    memset(screens, 0, sizeof screens);
    if (refused >= 0)
        p.halves[refused].refuses = 5;
    pthread_create(&threads[RENDERERS], 0, run_sender, &sender);
    for (int i = 0; i < RENDERERS; i++) {
        drawing *const d = &drawings[i];

        memset(d, 0, sizeof *d);
        d->renderer = (adapter_freertos_renderer){&sender, &d->task, 0};
        d->config = adapted_config(&glint_format_rgb565, adapter_freertos_flush(&d->renderer), i);
        d->config.left = (int16_t)(i * ADAPTED_WIDTH);
        pthread_create(&threads[i], 0, draw, d);
    }
    for (int i = 0; i < RENDERERS; i++)
        pthread_join(threads[i], 0);
    pthread_mutex_lock(&lock);
    queue.is_closed = 1;
    pthread_cond_broadcast(&changed);
    pthread_mutex_unlock(&lock);
    pthread_join(threads[RENDERERS], 0);
    return p;
}

static int shows(int number, const uint8_t *expected) {
    return memcmp(screens[number], expected, 2 * ADAPTED_WIDTH * ADAPTED_HEIGHT) == 0;
}

void freertos_tasks_share_a_panel(void) {
    const uint8_t *const expected = adapted_expected(&glint_format_rgb565);
    const panel p = draw_both(-1);

    for (int i = 0; i < RENDERERS; i++) {
        CHECK_EQUAL(drawings[i].status, GLINT_OK);
        CHECK_EQUAL(p.halves[i].sent, 3 * 12);
        CHECK(shows(i, expected));
    }
    CHECK_EQUAL(p.waits, RENDERERS * 3 * 12);
}

void freertos_error_ends_its_frame_only(void) {
    const uint8_t *const expected = adapted_expected(&glint_format_rgb565);

    draw_both(1);
    CHECK_EQUAL(drawings[0].status, GLINT_OK);
    CHECK(shows(0, expected));
    CHECK_EQUAL(drawings[1].status, GLINT_ERROR_FLUSH);
    CHECK_EQUAL(drawings[1].flush_error, 5);
    CHECK(!shows(1, expected));
}
