/* SPDX-License-Identifier: MIT */
/**
 * @file info.c
 * What there is to know of a model, and what its mesh takes of a board.
 */
#include "command.h"

#include "basics.h"
#include "view.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/** The settings with a panel's size and format. */
static host_settings on_panel(const report_subject *subject, const settings_panel *panel) {
    host_settings framed = *subject->settings;
    framed.width = panel->width;
    framed.height = panel->height;
    framed.format = panel->format;
    return framed;
}

/** Bytes of arena that indices of 8 bits take, which the meshes here do not have. */
static size_t decoded_bytes(const quantised_mesh *mesh) {
    size_t bytes = 0;
    for (size_t i = 0; i < mesh->piece_count; i++) {
        if (quantised_small_indices(mesh, &mesh->pieces[i])) {
            bytes += ((size_t)mesh->pieces[i].triangle_count * 6 + 7) / 8 * 8;
        }
    }
    return bytes;
}

/**
 * Finds the bytes of arena that the framed model needs on a panel, two tile buffers included.
 * @return false with a problem
 */
static bool report_arena(const report_subject *subject, const settings_panel *panel, glint_need *need,
                         host_problem *problem) {
    const host_settings framed = on_panel(subject, panel);
    host_view view;
    if (!view_make(&view, &framed, subject->materials, subject->mesh, problem)) {
        return false;
    }
    const glint_status status = view_need(&view.scene, &framed, need);
    view_free(&view);
    if (status != GLINT_OK) {
        return problem_set(problem, 0, "%s", glint_strerror(status));
    }
    const size_t decoded = decoded_bytes(subject->mesh);
    need->resident += decoded;
    need->one_pass += decoded;
    return true;
}

/* ---- A converted mesh ------------------------------------------------------------------------------------------- */

static glint_q16 scaled(glint_q16 length, glint_q16 longest) {
    return longest > 0 ? (glint_q16)((int64_t)length * GLINT_ONE / longest) : 0;
}

/** The pieces about the origin, the longest extent 1; their steps stay, and the caller frees the pieces alone. */
static quantised_mesh about_origin(const quantised_mesh *mesh) {
    quantised_mesh moved = *mesh;
    moved.pieces = memory_new(mesh->piece_count, sizeof *moved.pieces);
    for (size_t i = 0; i < mesh->piece_count; i++) {
        glint_mesh *piece = &moved.pieces[i];
        *piece = mesh->pieces[i];
        const glint_vector extent = piece->extent;
        glint_q16 longest = extent.x > extent.y ? extent.x : extent.y;
        longest = extent.z > longest ? extent.z : longest;
        memset(&piece->offset, 0, sizeof piece->offset);
        piece->extent.x = scaled(extent.x, longest);
        piece->extent.y = scaled(extent.y, longest);
        piece->extent.z = scaled(extent.z, longest);
    }
    return moved;
}

bool report_print(const report_subject *subject, host_problem *problem) {
    const settings_panel *panel = &subject->settings->panel;
    host_settings unturned = *subject->settings; /* the mesh itself was turned */
    quantised_mesh moved = about_origin(subject->mesh);
    const report_subject here = {&unturned, subject->materials, &moved};
    glint_need need;
    memset(unturned.rotate, 0, sizeof unturned.rotate);
    printf("vertices %zu\n", moved.vertex_count);
    printf("triangles %zu\n", moved.triangle_count);
    printf("flash_bytes %zu\n", quantised_size(&moved) + textures_size(subject->materials));
    textures_print(subject->materials);
    printf("largest_move %.3g\n", subject->mesh->largest_move);
    printf("largest_turn %.3g\n", subject->mesh->largest_turn);
    bool ok = report_arena(&here, panel, &need, problem);
    if (ok) {
        printf("panel %ux%u %s\n", panel->width, panel->height, panel->format->name);
        printf("arena_least %zu\narena_resident %zu\narena_one_pass %zu\n", need.least, need.resident, need.one_pass);
    }
    free(moved.pieces);
    return ok;
}

/* ---- Counts -------------------------------------------------------------------------------------------------------
 */

/** Panels that people have, for the table of arenas. */
static const struct info_panel {
    uint16_t width, height;
    const char *format;
} panels[] = {
    {128, 64, "grey4"}, {128, 128, "rgb565"}, {160, 128, "rgb565"}, {240, 240, "rgb565"}, {320, 240, "rgb565"},
};

static void print_winding(const host_model *model) {
    const mesh_winding winding = mesh_check_winding(&model->mesh);
    printf("parts %zu\n", winding.part_count);
    printf("mixed_parts %zu\n", winding.mixed_parts);
    printf("inward_parts %zu\n", winding.inward_parts);
    printf("one_sided_parts %zu\n", winding.one_sided_parts);
    printf("triangles_turned %zu\n", model->turned_count);
}

static void print_counts(const host_model *model, const quantised_mesh *mesh) {
    const mesh_topology topology = mesh_check_topology(&model->mesh);
    size_t clusters = 0;
    for (size_t i = 0; i < mesh->piece_count; i++) {
        clusters += mesh->pieces[i].clusters != NULL ? mesh->pieces[i].clusters->count : 0;
    }
    const bool all = model->given_normals == model->corner_count;
    printf("positions %zu\n", model->mesh.position_count);
    printf("positions_used %zu\n", topology.point_count);
    printf("vertices %zu\n", mesh->vertex_count);
    printf("positions_welded %zu\n", model->welded_count);
    printf("faces %zu\n", model->mesh.face_count);
    printf("triangles %zu\n", mesh->triangle_count);
    printf("triangles_read %zu\n", model->read_count);
    printf("geometric_error %.3g\n", model->error);
    printf("triangles_dropped %zu\n", mesh->dropped_count);
    printf("groups %zu\n", model->mesh.group_count);
    printf("pieces %zu\n", mesh->piece_count);
    printf("clusters %zu\n", clusters);
    printf("normals %s\n", all ? "given" : model->given_normals == 0 ? "computed" : "partly given");
    printf("boundary_edges %zu\n", topology.boundary_edges);
    printf("inconsistent_edges %zu\n", topology.inconsistent_edges);
    printf("shared_edges %zu\n", topology.shared_edges);
    print_winding(model);
    printf("colours %s\n", model->mesh.colours != NULL ? "given" : "none");
    printf("materials %zu\n", model->materials.used_count);
    printf("flash_bytes %zu\n", quantised_size(mesh) + textures_size(&model->materials));
    textures_print(&model->materials);
}

static void print_bounds(const host_model *model, const quantised_mesh *mesh) {
    const double *low = model->low;
    const double *high = model->high;
    printf("lowest %.6g %.6g %.6g\n", low[0], low[1], low[2]);
    printf("highest %.6g %.6g %.6g\n", high[0], high[1], high[2]);
    printf("largest_move %.3g\n", mesh->largest_move / model->fit);
    printf("largest_turn %.3g\n", mesh->largest_turn);
}

/** One line of print_types: what a type saves of the flash of 16 bits, and what error it brings. */
static void print_type(const host_model *model, const quantised_mesh *plain, const char *option, const char *name,
                       quantise_types types) {
    quantised_mesh other;
    host_problem problem;
    if (!quantise(&model->mesh, 0, &types, &other, &problem)) {
        printf("%-12s %-14s does not fit\n", option, name);
        return;
    }
    const double before = (double)quantised_size(plain);
    printf("%-12s %-14s %8.0f %5.1f%% %10.3g %8.3g\n", option, name, before - (double)quantised_size(&other),
           100 * (before - (double)quantised_size(&other)) / before, other.largest_move / model->fit,
           other.largest_turn);
    quantised_free(&other);
}

/** What each type of an attribute saves, by itself and all together. */
static void print_types(const host_model *model) {
    quantised_mesh plain;
    host_problem problem;
    if (!quantise(&model->mesh, 0, NULL, &plain, &problem)) {
        return;
    }
    printf("\nBytes of flash that types save, of %zu without clusters; the largest move of a position, in the model's "
           "units,\nand turn of a normal, in degrees:\n",
           quantised_size(&plain));
    print_type(model, &plain, "--positions", "int16", (quantise_types){0});
    print_type(model, &plain, "--positions", "int8", (quantise_types){.positions = QUANTISE_POSITIONS_INT8});
    print_type(model, &plain, "--normals", "octahedral16", (quantise_types){.normals = QUANTISE_NORMALS_OCTAHEDRAL16});
    print_type(model, &plain, "--normals", "octahedral", (quantise_types){.normals = QUANTISE_NORMALS_OCTAHEDRAL});
    print_type(model, &plain, "--indices", "8", (quantise_types){.indices = QUANTISE_INDICES_8});
    print_type(model, &plain, "all", "8 or auto",
               (quantise_types){QUANTISE_POSITIONS_INT8, QUANTISE_NORMALS_OCTAHEDRAL, QUANTISE_INDICES_AUTO});
    quantised_free(&plain);
}

/** Prints the arena that the framed model needs on a panel. @return false with a problem */
static bool print_panel(const report_subject *subject, const settings_panel *panel, host_problem *problem) {
    glint_need need;
    if (!report_arena(subject, panel, &need, problem)) {
        return false;
    }
    char size[16];
    snprintf(size, sizeof size, "%ux%u", panel->width, panel->height);
    printf("%-8s %-7s %9zu %9zu %9zu\n", size, panel->format->name, need.least, need.resident, need.one_pass);
    return true;
}

/** The same for the settings' panel, or for all that people have. */
static bool print_panels(const report_subject *subject, host_problem *problem) {
    const settings_panel *given = &subject->settings->panel;
    bool ok = !subject->settings->panel_given || print_panel(subject, given, problem);
    for (size_t i = 0; ok && !subject->settings->panel_given && i < sizeof panels / sizeof panels[0]; i++) {
        const settings_panel panel = {panels[i].width, panels[i].height,
                                      framebuffer_find_format(panels[i].format, NULL)};
        ok = print_panel(subject, &panel, problem);
    }
    return ok;
}

int command_info(const host_settings *settings) {
    host_model model;
    quantised_mesh mesh;
    if (!command_load(settings, false, &model, &mesh)) {
        return COMMAND_FAILED;
    }
    print_counts(&model, &mesh);
    print_bounds(&model, &mesh);
    printf("\nBytes of arena to draw it framed, two tile buffers included: at least, with every vertex kept, in one "
           "pass:\n");
    host_problem problem;
    const report_subject subject = {settings, &model.materials, &mesh};
    const bool ok = print_panels(&subject, &problem);
    if (ok) {
        print_types(&model);
        command_print_warnings(settings, &model);
        command_warn_of_size(settings, &model.materials, &mesh);
    }
    quantised_free(&mesh);
    model_free(&model);
    return ok ? 0 : command_fail(NULL, &problem);
}
