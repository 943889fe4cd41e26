/* SPDX-License-Identifier: MIT */
/*
 * Draws random scenes and judges them: search FIRST COUNT [STRIDE]. Prints one line per region, as search.py reads it,
 * and one per scene that breaks the contract.
 */
#include "contract.h"
#include "picture.h"
#include "random_scene.h"

#include <stdio.h>
#include <stdlib.h>

#define REGIONS_MAX 32

/* What a region's scenes sum up to, and its worst one. */
typedef struct tally {
    judgement sum;
    long scenes, excused, moved, refused, broken;
    double worst_share, worst, bound;
    uint64_t worst_seed, worst_checksum;
} tally;

/* Whether the image is another with tiles of another size and the smallest arena, or any up to that of one pass. */
static int is_moved(const random_scene *s) {
    picture plain = picture_open(s->width, s->height, s->format);
    picture other = picture_open(s->width, s->height, s->format);
    picture_options options = {.tile_width = s->tile_width, .tile_height = s->tile_height};
    glint_config config = picture_config(&other, &options);
    glint_need need = {0};
    int moved = glint_arena_need(&config, &s->scene, &need) != GLINT_OK;
    options.arena_size = picture_arena(&need, s->seed / 8 % 2 ? 0 : (uint32_t)(s->seed / 16 % 257));
    moved = moved || picture_render(&plain, &s->scene, NULL, NULL) != GLINT_OK ||
            picture_render(&other, &s->scene, &options, NULL) != GLINT_OK || !picture_equal(&plain, &other);
    picture_close(&plain);
    picture_close(&other);
    return moved;
}

static const char *format_name(const glint_format *format) {
    return format == &glint_format_rgb565 ? "RGB565" : format == &glint_format_rgb888 ? "RGB888" : "grey8";
}

static void print_scene(const random_scene *s, const contract_result *result, int moved) {
    const judgement *found = &result->found;
    printf("scene,%llu,%s,%s,status %d,missed %ld,spilled %ld,fine %ld,one %ld,two %ld,moved %d,worst %.3f of %.3f at "
           "(%d %d) of %dx%d\n",
           (unsigned long long)s->seed, random_regions[s->region].name, format_name(s->format), found->status,
           found->missed, found->spilled, found->not_fine, found->over_one, found->over_two, moved, found->worst,
           result->bound, result->worst_x, result->worst_y, s->width, s->height);
}

static void judge_scene(const random_scene *scene, tally *tallies) {
    contract_result result;
    tally *t = &tallies[scene->region];
    contract_judge(&scene->scene, scene->width, scene->height, scene->format, &result);
    int moved = is_moved(scene);
    judgement_add(&t->sum, &result.found);
    t->scenes++;
    t->excused += result.excused;
    t->moved += moved;
    t->refused += result.found.status != GLINT_OK;
    t->broken += !contract_holds(&result);
    if (result.worst_share > t->worst_share) {
        t->worst_share = result.worst_share;
        t->worst = result.found.worst;
        t->bound = result.bound;
        t->worst_seed = scene->seed;
        t->worst_checksum = random_scene_checksum(scene);
    }
    if (!contract_holds(&result) || moved || result.found.over_one)
        print_scene(scene, &result, moved);
}

/* One scene of four is drawn again with textures. */
static void judge_seed(uint64_t seed, tally *tallies) {
    static random_scene scene;
    random_scene_make(&scene, seed);
    judge_scene(&scene, tallies);
    if (seed % 4 == 1) {
        random_scene_make_in(&scene, RANDOM_TEXTURED_REGION, seed);
        judge_scene(&scene, tallies);
    }
}

/* The columns of search.py, after the word "region". */
static void print_tally(const random_region *region, const tally *t) {
    const judgement *sum = &t->sum;
    printf("region,%s,%d,%ld,%ld,%ld,%ld,%ld,%ld,%ld,%ld,%ld,%ld,%ld,%ld,%ld,%ld,%.4f,%.4f,%.4f,%llu,0x%016llx\n",
           region->name, region->in_contract, t->scenes, sum->covered, sum->judged, sum->uncertain, sum->close,
           sum->gated, t->excused, sum->not_fine, sum->over_one, sum->over_two, sum->missed + t->refused, sum->spilled,
           t->moved, t->broken, t->worst_share, t->worst, t->bound, (unsigned long long)t->worst_seed,
           (unsigned long long)t->worst_checksum);
}

int main(int argc, char **argv) {
    static tally tallies[REGIONS_MAX];
    if (argc < 3) {
        fputs("usage: search FIRST COUNT [STRIDE]\n", stderr);
        return 2;
    }
    uint64_t first = strtoull(argv[1], NULL, 10);
    uint64_t count = strtoull(argv[2], NULL, 10);
    uint64_t stride = argc > 3 ? strtoull(argv[3], NULL, 10) : 1;
    for (uint64_t i = 0; i < count; i++)
        judge_seed(first + i * stride, tallies);
    for (unsigned i = 0; i < random_region_count; i++)
        print_tally(&random_regions[i], &tallies[i]);
    return 0;
}
