/* SPDX-License-Identifier: MIT */
#include "level_set.h"

#include "picture.h"

#include <math.h>

level_place level_place_of(const glint_format *format, int x, int y) {
    level_place at = {.channels = picture_channels(format), .threshold = picture_threshold(format, x, y)};
    for (int channel = 0; channel < at.channels; channel++)
        at.most[channel] = picture_level_max(format, channel);
    at.coarse = glint_row_bytes(format, 8) == 16 ? 1.0 / 32 : 0;
    return at;
}

static uint8_t cut_off(const level_place *at, int channel, double value) {
    return (uint8_t)fmax(0, fmin(at->most[channel], floor(value + at->threshold)));
}

/* Of 1; a single channel is the luma. */
static double value_of(const double colour[3], int channels, int channel) {
    return channels == 1 ? 0.299 * colour[0] + 0.587 * colour[1] + 0.114 * colour[2] : colour[channel];
}

void level_set_surface(level_set *to, const level_place *at, const reference_pixel *pixel, double slack) {
    to->count = 1 + pixel->choice_count;
    for (int i = 0; i < to->count; i++) {
        const double *const least = i ? pixel->choices[i - 1].least : pixel->colour, *const most =
                                                                                         i ? pixel->choices[i - 1].most
                                                                                           : pixel->colour;
        for (int c = 0; c < at->channels; c++) {
            to->least[i][c] = cut_off(at, c, at->most[c] * value_of(least, at->channels, c) - slack);
            to->most[i][c] = cut_off(at, c, at->most[c] * value_of(most, at->channels, c) + slack);
        }
    }
}

void level_set_known(level_set *to, const level_place *at, const int level[3]) {
    to->count = 1;
    for (int c = 0; c < at->channels; c++)
        to->least[0][c] = to->most[0][c] = (uint8_t)level[c];
}

/* One alternative of each of two sets; at the ends of a share, for what is mixed runs from one to the other. */
static void mix_alternatives(level_set *to, const level_place *at, const level_set *set, int i, const level_set *over,
                             int j, level_share part, int adds) {
    for (int c = 0; c < at->channels; c++) {
        const double kept[2] = {adds ? 1 : 1 - part.least, adds ? 1 : 1 - part.most};
        const double share[2] = {part.least, part.most};
        double least = INFINITY, most = -INFINITY;
        for (int end = 0; end < 2; end++) {
            least = fmin(least, kept[end] * set->least[i][c] + share[end] * over->least[j][c]);
            most = fmax(most, kept[end] * set->most[i][c] + share[end] * over->most[j][c]);
        }
        to->least[to->count][c] = cut_off(at, c, least);
        to->most[to->count][c] = cut_off(at, c, most);
    }
    to->count++;
}

void level_set_mix(level_set *set, const level_place *at, const level_set *over, level_share part, int adds) {
    level_set mixed = {0};
    for (int i = 0; i < set->count && set->count * over->count <= LEVEL_SET_MAX; i++)
        for (int j = 0; j < over->count; j++)
            mix_alternatives(&mixed, at, set, i, over, j, part, adds);
    *set = mixed;
}

int level_set_distance(const level_set *set, const level_place *at, const int level[3]) {
    int nearest = 256;
    for (int i = 0; i < set->count; i++) {
        int apart = 0;
        for (int c = 0; c < at->channels; c++) {
            const int below = set->least[i][c] - level[c], above = level[c] - set->most[i][c];
            const int outside = below > above ? below : above;
            apart = outside > apart ? outside : apart;
        }
        nearest = apart < nearest ? apart : nearest;
    }
    return nearest;
}
