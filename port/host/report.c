/* SPDX-License-Identifier: MIT */
#include "report.h"

#include "memory.h"
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

bool report_arena(const report_subject *subject, const settings_panel *panel, glint_need *need, host_problem *problem) {
    const host_settings framed = on_panel(subject, panel);
    host_view view;
    if (!view_make(&view, &framed, subject->materials, subject->mesh, problem)) {
        return false;
    }
    glint_config config = {.width = framed.width, .height = framed.height, .format = framed.format->format};
    framebuffer target = {0}; /* not drawn to: a port that waits takes two tile buffers, and this one does */
    config.flush = framebuffer_flush(&target);
    const glint_status status = glint_arena_need(&config, &view.scene, need);
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
    printf("flash_bytes %zu\n", quantised_size(&moved));
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
