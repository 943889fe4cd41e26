/* SPDX-License-Identifier: MIT */
#include "judge.h"

#include "library_geometry.h"
#include "picture.h"
#include "reference.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

typedef struct images {
    reference_image reference;
    picture shaded;  /* in the task's format, */
    uint16_t *depth; /* and where that shows objects */
    double depth_scale;
    int channels, most[3]; /* of the format */
} images;

static void measure_vertices(const judge_task *task, const library_geometry *geometry, judgement *total) {
    for (uint32_t object = 0; object < task->scene->object_count; object++) {
        uint32_t count = task->scene->objects[object].mesh->vertex_count;
        for (uint32_t index = 0; index < count; index++) {
            const reference_position *snapped = &geometry->positions[object][index];
            if (!snapped->known)
                continue;
            reference_vertex exact = reference_transform(task->scene, object, index, task->width, task->height);
            double error = fmax(fabs(snapped->x / 16.0 - exact.x), fabs(snapped->y / 16.0 - exact.y));
            total->vertex_error = fmax(total->vertex_error, error);
        }
    }
}

/*
 * Largest distance over the channels of a pixel, from the unrounded and from the rounded reference, in steps. A
 * dithered pixel is rounded at its threshold: what it is half a step from lies by that much elsewhere.
 */
typedef struct distance {
    double unrounded;
    int rounded;
    int is_fine;
    int is_beside;
    double squares;
} distance;

/* Finds what a pixel should show nearest to what it shows, in levels. @return whether that is a texel beside its own */
static int find_wanted(const images *all, int x, int y, double wanted[3]) {
    const double threshold = picture_threshold(all->shaded.format, x, y);
    double stored[3];
    for (int channel = 0; channel < all->channels; channel++)
        stored[channel] = picture_level(&all->shaded, x, y, channel) + 0.5 - threshold;
    return reference_find_wanted(&all->reference.pixels[y * all->reference.width + x], all->channels, all->most, stored,
                                 wanted);
}

static distance measure_pixel(const judge_task *task, const images *all, int x, int y) {
    const picture *shaded = &all->shaded;
    const double threshold = picture_threshold(shaded->format, x, y);
    double wanted[3];
    distance result = {0, 0, 1, find_wanted(all, x, y, wanted), 0};
    for (int channel = 0; channel < all->channels; channel++) {
        int stored = picture_level(shaded, x, y, channel);
        double error = fabs(stored + 0.5 - threshold - wanted[channel]);
        double relative = (stored - wanted[channel]) / all->most[channel];
        int steps = abs(stored - (int)floor(wanted[channel] + threshold));
        double fine = task->fine_of[0] > 0 ? task->fine_of[channel] : task->fine;
        result.unrounded = fmax(result.unrounded, error);
        result.is_fine = result.is_fine && error <= fine;
        result.rounded = steps > result.rounded ? steps : result.rounded;
        result.squares += relative * relative;
    }
    return result;
}

/* Is a pixel rounded to other levels than the reference's? */
static int is_apart(const images *all, int x, int y) {
    const double threshold = picture_threshold(all->shaded.format, x, y);
    double wanted[3];
    int apart = 0;
    (void)find_wanted(all, x, y, wanted);
    for (int channel = 0; channel < all->channels; channel++)
        apart |= picture_level(&all->shaded, x, y, channel) != (int)(wanted[channel] + threshold);
    return apart;
}

static void judge_pixel(const judge_task *task, const images *all, int x, int y, judgement *total) {
    const reference_pixel *reference = &all->reference.pixels[y * task->width + x];
    int drawn = all->depth[y * task->width + x] > 0;
    total->covered += reference->covered;
    const double keyed = reference->keyed * all->depth_scale;
    if (reference->uncertain ||
        (keyed > 0 && keyed >= reference->nearest * all->depth_scale && keyed * JUDGE_FAR < 65536)) {
        total->uncertain++;
        return;
    }
    if (drawn != reference->covered) {
        total->missed++;
        return;
    }
    if (!reference->covered) {
        total->spilled += is_apart(all, x, y);
        return;
    }
    if (reference->unsettled) {
        total->unsettled++;
        return;
    }
    const distance error = measure_pixel(task, all, x, y);
    total->squares += error.squares;
    total->samples += all->channels;
    if (reference->second > 0 && (reference->nearest - reference->second) * all->depth_scale < JUDGE_CLOSE_STEPS) {
        total->close++;
        return;
    }
    total->gated += reference->grazing < JUDGE_GATE;
    if (task->leave_out_gates && reference->grazing < JUDGE_GATE)
        return;
    total->judged++;
    total->beside += error.is_beside;
    total->apart += error.rounded > 0;
    total->over_one += error.rounded > 1;
    total->over_two += error.rounded > 2;
    total->not_fine += !error.is_fine;
    if (error.unrounded > total->worst) {
        total->worst = error.unrounded;
        total->worst_x = x;
        total->worst_y = y;
    }
}

static glint_status draw_all(const judge_task *task, images *all, judgement *total) {
    library_geometry geometry;
    picture_options options = {0};
    glint_config config = picture_config(&all->shaded, &options);
    glint_status status = library_geometry_open(&geometry, &config, task->scene);
    if (status == GLINT_OK) {
        all->depth_scale = geometry.depth_scale;
        measure_vertices(task, &geometry, total);
        reference_render(&all->reference, task->scene, (const reference_position *const *)geometry.positions);
        options.depth = all->depth;
        status = picture_render(&all->shaded, task->scene, &options, NULL);
    }
    library_geometry_close(&geometry);
    return status;
}

void judge(const judge_task *task, judgement *total) {
    images all = {.reference = {.width = task->width, .height = task->height},
                  .shaded = picture_open(task->width, task->height, task->format),
                  .depth = calloc((size_t)task->width * (size_t)task->height, sizeof *all.depth),
                  .channels = picture_channels(task->format)};
    for (int channel = 0; channel < all.channels; channel++)
        all.most[channel] = picture_level_max(task->format, channel);
    all.reference.pixels = malloc((size_t)task->width * (size_t)task->height * sizeof *all.reference.pixels);
    glint_status status = all.reference.pixels && all.depth ? draw_all(task, &all, total) : GLINT_ERROR_NULL;
    if (status != GLINT_OK)
        total->status = status;
    for (int y = 0; y < task->height && status == GLINT_OK; y++) {
        for (int x = 0; x < task->width; x++)
            judge_pixel(task, &all, x, y, total);
    }
    free(all.reference.pixels);
    picture_close(&all.shaded);
    free(all.depth);
}

void judgement_add(judgement *total, const judgement *part) {
    judgement sum = part->worst > total->worst ? *part : *total;
    sum.status = total->status != GLINT_OK ? total->status : part->status;
    sum.covered = total->covered + part->covered;
    sum.missed = total->missed + part->missed;
    sum.uncertain = total->uncertain + part->uncertain;
    sum.spilled = total->spilled + part->spilled;
    sum.close = total->close + part->close;
    sum.gated = total->gated + part->gated;
    sum.unsettled = total->unsettled + part->unsettled;
    sum.beside = total->beside + part->beside;
    sum.judged = total->judged + part->judged;
    sum.apart = total->apart + part->apart;
    sum.over_one = total->over_one + part->over_one;
    sum.over_two = total->over_two + part->over_two;
    sum.not_fine = total->not_fine + part->not_fine;
    sum.vertex_error = fmax(total->vertex_error, part->vertex_error);
    sum.squares = total->squares + part->squares;
    sum.samples = total->samples + part->samples;
    *total = sum;
}

/* At most 1 in `share` pixels of a frame, or a few of them. */
static int is_rare(long pixels, long judged, long share, long few) {
    return pixels <= few || pixels * share <= judged;
}

int judgement_keeps_contract(const judgement *frame) {
    return frame->status == GLINT_OK && frame->missed == 0 && frame->spilled == 0 &&
           is_rare(frame->over_one, frame->judged, 10000, 2) && is_rare(frame->not_fine, frame->judged, 1000, 3);
}

int judgement_keeps_fine_contract(const judgement *frame) {
    return frame->status == GLINT_OK && frame->missed == 0 && frame->spilled == 0 &&
           is_rare(frame->over_two, frame->judged, 2000, 2) && is_rare(frame->not_fine, frame->judged, 200, 3);
}

double judgement_psnr(const judgement *total) {
    return total->squares > 0 ? -10 * log10(total->squares / (double)total->samples) : INFINITY;
}
