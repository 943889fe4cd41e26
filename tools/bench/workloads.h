/* SPDX-License-Identifier: MIT */
/**
 * @file workloads.h
 * What frames are counted of: the benchmark scenes, one of them under every kind of light, material and evaluation and
 * in every pixel format, boxes, and example scenes. Scenes, not how they are drawn: any program that reads glint_scene
 * can go through the list,
 *
 *     for (uint32_t i = 0; i < workload_count(); i++) {
 *         const workload drawn = workload_get(i);
 *         workload_build(&stage, &drawn);
 *         for (uint32_t frame = 0; frame < drawn.frames; frame++) {
 *             workload_set_frame(&stage, frame);
 *             draw stage.example.scene, drawn.width by drawn.height, in drawn.output->format, with the stage.example's
 *             layers and samples
 *         }
 *     }
 */
#ifndef GLINT_BENCH_WORKLOADS_H
#define GLINT_BENCH_WORKLOADS_H

#include "../../examples/scenes/scenes.h"
#include "boxes.h"

/** Room for the name of a variant and its end. */
#define WORKLOAD_TEXT 64

/** The first ones are benchmark scenes as they are, which frames.c draws in more ways. */
#define WORKLOADS_PLAIN 8

/** The torus of 576 triangles at 320x240 under 1, 2, 4 and 8 directional lights, points and spots. */
#define WORKLOADS_LIGHTS 12

/** What a workload is built in; owned by the caller, and not to be moved while it is drawn. */
typedef struct workload_stage {
    example_stage example;
    glint_mesh mesh;
    uint8_t colours[288][3];     /**< The vertices of torus576; */
    int16_t coordinates[288][2]; /**< what they show of a texture, */
    uint16_t texels[64 * 64];    /**< and its texels. */
    glint_texture texture;
    glint_pose turned[10];                  /**< What stands in place of the torus, in each frame. */
    glint_mesh meshes[EXAMPLE_OBJECTS_MAX]; /**< An example's, without colours. */
    const glint_pose *poses;                /**< Of a benchmark scene's frames, or null. */
    const boxes_definition *boxes;          /**< Or null. */
    glint_object box_objects[BOXES_MAX];
} workload_stage;

/** How pixels are stored. */
typedef struct workload_output {
    const char *name; /**< "" for RGB565. */
    const glint_format *format;
    uint8_t pages; /**< Not 0: a byte holds 8 pixels of a column. */
    uint8_t gamma; /**< Not 0: through workload_gamma. */
} workload_output;

/** Changes a benchmark scene. */
typedef void (*workload_change)(workload_stage *stage);

typedef struct workload {
    const char *scene; /**< Its name. */
    const char *look;  /**< What it shows of the scene; "" where it is as ever. */
    uint16_t width, height;
    uint32_t frames;
    const workload_output *output;
    const example_scene *example;  /**< Or null; */
    const char *variant;           /**< of an example; */
    const boxes_definition *boxes; /**< or null. Else a benchmark scene: */
    uint32_t bench;                /**< that of so many, */
    workload_change change;        /**< either changed, or null. */
    uint8_t by_default;            /**< Not 0: with an infinite viewer, as a scene has it that names none. */
} workload;

uint32_t workload_count(void);

/** That number `number`, below workload_count. */
workload workload_get(uint32_t number);

/** Number `number` of those that differ in lights alone, below WORKLOADS_LIGHTS; workload_get has them too. */
workload workload_get_lights(uint32_t number);

/** Builds its first frame in `stage`. @return 0, or 1 where the example scene has no such variant */
int workload_build(workload_stage *stage, const workload *built);

/** Returns whether what was built has no texture, no fog, no layers and no samples. */
int workload_is_bare(const workload_stage *stage);

/** Makes it frame number `frame`. */
void workload_set_frame(workload_stage *stage, uint32_t frame);

/** Size, viewer, tiles, look and format, as rows name them. @return text */
const char *workload_variant(const workload *named, char text[WORKLOAD_TEXT]);

/** Output tables, the same for each channel: the square root. */
void workload_gamma(uint16_t tables[3][GLINT_GAMMA_ENTRIES]);

#endif
