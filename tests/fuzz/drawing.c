/* SPDX-License-Identifier: MIT */
#include "drawing.h"

#include "quantise.h"

void take_mesh_colours(source *s, glint_mesh *mesh) {
    uint32_t choice = below(s, 6);
    uint32_t state = take(s, 2);
    uint8_t(*colours)[3] = allocate(mesh->vertex_count * sizeof *colours);
    uint16_t *colours565 = allocate(mesh->vertex_count * sizeof *colours565);
    for (uint32_t i = 0; i < mesh->vertex_count; i++) {
        for (int c = 0; c < 3; c++)
            colours[i][c] = (uint8_t)next_random(&state);
        colours565[i] = (uint16_t)next_random(&state);
    }
    if (choice == 1 || choice == 3)
        mesh->colours = (const uint8_t(*)[3])colours;
    else
        free(colours);
    if (choice == 2 || choice == 3)
        mesh->colours565 = colours565;
    else
        free(colours565);
}

void free_drawing(drawing *d) {
    for (int i = 0; i < DRAWING_MESHES; i++) {
        free((void *)(uintptr_t)d->meshes[i].positions);
        free((void *)(uintptr_t)d->meshes[i].normals);
        free((void *)(uintptr_t)d->meshes[i].triangles);
        free((void *)(uintptr_t)d->meshes[i].colours);
        free((void *)(uintptr_t)d->meshes[i].colours565);
        free((void *)(uintptr_t)d->meshes[i].texture_coordinates);
        cluster_free(&d->meshes[i]);
        for (int j = 0; j < 4; j++)
            free(d->stored[i][j]);
    }
    for (int i = 0; i < DRAWING_OBJECTS; i++) {
        free((void *)(uintptr_t)d->texels[i]);
        free((void *)(uintptr_t)d->palettes[i]);
        for (int j = 0; j < DRAWING_LEVELS; j++)
            free((void *)(uintptr_t)d->levels[i][j].texels);
    }
}
