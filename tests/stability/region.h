/* SPDX-License-Identifier: MIT */
/**
 * @file region.h
 * A region where methods fail, as one row of docs/stability.md: how far a plain method is off there, how far the
 * library is, and what the library does.
 */
#ifndef GLINT_STABILITY_REGION_H
#define GLINT_STABILITY_REGION_H

#include "judge.h"
#include "random_scene.h"

/** What was found; `library` holds the formats RGB888 and RGB565. */
typedef struct region_figures {
    double plain;
    double library[2];  /**< Largest error, in the region's unit; of colours, steps of each format. */
    double bound[2];    /**< What the contract allows: of colours, 99.9 % of the pixels. */
    judgement found[2]; /**< Of what was judged; none where nothing was. */
} region_figures;

typedef struct region {
    const char *name;
    const char *plain; /**< The plain method. */
    const char *unit;  /**< Of `plain` and, but for colours, of `library`. */
    const char *does;  /**< What the library does. */
    double fails;      /**< The plain method is off by at least this: the region is a hard one. */
    void (*measure)(region_figures *figures);
} region;

/** Colour errors, in steps of 255. */
#define REGION_STEPS "steps of 255"

extern const region highlight_regions[], normal_regions[], power_regions[], light_regions[], triangle_regions[],
    pose_regions[], screen_regions[], input_regions[];
extern const unsigned highlight_region_count, normal_region_count, power_region_count, light_region_count,
    triangle_region_count, pose_region_count, screen_region_count, input_region_count;

/** All of them in the order of the table: region i and its topic, or null beyond the last. */
const region *region_at(unsigned i, const char **topic);

/** Does a region's plain method fail, and does the library keep to the contract? Reports to the test harness. */
void region_check(const region *which, const region_figures *figures);

/* ---- Scenes to begin with, and judging them --------------------------------------------------------------------- */

/**
 * A square of 2 x 2 at distance 3 fills a screen of 64 x 64; a white light from the viewer; ambient 0.1, diffuse 0.4,
 * specular 0.5, p = 32.
 */
void region_square(random_scene *s);

/** The same with a sphere of radius 1 in the square's place. */
void region_sphere(random_scene *s, uint32_t around, uint32_t along);

/** Normals of the square's corners: lower left, lower right, upper right, upper left. Made 32767 long. */
void region_normals(random_scene *s, const double normals[4][3]);

/** The light's direction. */
void region_light(random_scene *s, double x, double y, double z);

void region_weights(random_scene *s, double ambient, double diffuse, double specular);

/** A number in Q16.16. */
glint_q16 region_q16(double value);

/** Judges by the contract in both formats, and brings figures->library up to date. */
void region_judge(const random_scene *s, region_figures *figures);

/** The same for both viewers. */
void region_judge_viewers(random_scene *s, region_figures *figures);

/** The same, nothing left out for ill-told directions: as judge.h has it. */
void region_judge_all(const random_scene *s, region_figures *figures);

/** The same, and the pixels wrongly covered as the figures. */
void region_judge_coverage(const random_scene *s, region_figures *figures);

/** Keeps the larger. */
void region_raise(double *figure, double value);

#endif
