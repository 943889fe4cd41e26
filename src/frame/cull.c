/* SPDX-License-Identifier: MIT */
/* Drops clusters of triangles that face away as a whole, and the vertices that only they use. */

#include "frame.h"

/* Compilers call this even in freestanding code; here the library does. */
void *memset(void *bytes, int value, size_t size);

/* The rounding of an eye is less than this in the test of a cluster. */
#define ROUNDING (1 << 16)

static glint_status check(const glint_mesh *mesh) {
    const glint_clusters *clusters = mesh->clusters;
    uint32_t triangles = 0, vertices = 0;
    if (!clusters->list)
        return GLINT_ERROR_NULL;
    if (clusters->count > 65536)
        return GLINT_ERROR_MESH;
    for (uint32_t i = 0; i < clusters->count; i++) {
        triangles += clusters->list[i].triangles;
        vertices += clusters->list[i].vertices;
    }
    return triangles == mesh->triangle_count && vertices == mesh->vertex_count ? GLINT_OK : GLINT_ERROR_MESH;
}

/* Finds the eye of an object. A double-sided object is seen from nowhere: then no triangle faces away. */
static void find_eye(const glint_transform *transform, const glint_mesh *mesh, glint_eye *eye) {
    glint_transform_eye(transform, eye);
    if (mesh->flags & GLINT_MESH_DOUBLE_SIDED)
        *eye = (glint_eye){0};
}

/* Finds for each of some clusters whether all its triangles face away, 1 or 0. */
static void face(const glint_eye *eye, const glint_cluster *c, uint32_t count, uint8_t *away) {
    const glint_eye from = *eye;
    for (const glint_cluster *const end = c + count; c < end; c++) {
        const int32_t turn = ROUNDING + c->axis[0] * from.x + c->axis[1] * from.y + c->axis[2] * from.z +
                             c->spread * from.distance - c->height * from.weight;
        *away++ = (uint8_t)((uint32_t)turn >> 31);
    }
}

/* ---- Draws of all that is left of a mesh ---- */

/* Do a cluster and its borrowers, those from `first` on, all face away? They do not where a borrower is not valid. */
static int are_all_away(const glint_clusters *clusters, const uint8_t *away, uint32_t cluster, uint32_t first) {
    const uint32_t end = first + clusters->list[cluster].borrowers;
    if (!away[cluster])
        return 0;
    for (uint32_t i = first; i < end; i++)
        if (!clusters->borrowers || clusters->borrowers[i] >= clusters->count || !away[clusters->borrowers[i]])
            return 0;
    return 1;
}

/* Loads vertices from one to before another. Unused ones are 0, as a mesh that errs may name them all the same. */
static void load_some(glint_frame *frame, glint_draw *draw, const glint_mesh *mesh, uint32_t from, uint32_t to,
                      int away) {
    if (away)
        memset(draw->vertices + from, 0, (to - from) * sizeof *draw->vertices);
    else
        glint_load_vertices(frame, draw, mesh, from, from, to - from);
}

/* Loads the vertices that clusters use, except those that face away. */
static void load_clusters(glint_frame *frame, glint_draw *draw, const glint_mesh *mesh) {
    const glint_clusters *clusters = mesh->clusters;
    uint32_t borrowers = 0, from = 0, to = 0;
    int last = 0; /* of the vertices from `from` to before `to` */
    for (uint32_t i = 0; i < clusters->count; i++) {
        const int away = are_all_away(clusters, draw->away, i, borrowers);
        if (away != last) {
            load_some(frame, draw, mesh, from, to, last);
            from = to;
            last = away;
        }
        borrowers += clusters->list[i].borrowers;
        to += clusters->list[i].vertices;
    }
    load_some(frame, draw, mesh, from, to, last);
}

static void load(glint_frame *frame, glint_draw *draw, const glint_mesh *mesh) {
    const glint_clusters *clusters = mesh->clusters;
    glint_eye eye;
    find_eye(&draw->transform, mesh, &eye);
    draw->away = glint_take(&frame->memory, clusters->count);
    face(&eye, clusters->list, clusters->count, draw->away);
    if (draw->positions || draw->extra)
        glint_load_vertices(frame, draw, mesh, 0, 0, mesh->vertex_count);
    else
        load_clusters(frame, draw, mesh);
}

static int bin(glint_bin_pass *pass, glint_draw *draw, uint32_t next) {
    glint_frame *const frame = pass->frame;
    const glint_clusters *clusters = glint_object_at(frame, draw->object)->mesh->clusters;
    int32_t end = 0;
    for (uint32_t i = 0; i < clusters->count; i++) {
        const int32_t begin = end;
        end += clusters->list[i].triangles;
        if (!draw->away[i] || end <= (int32_t)next)
            continue;
        if ((int32_t)next < begin) {
            const int binned = glint_bin_some(pass, draw, next, (uint32_t)begin);
            if (binned != begin)
                return binned;
            next = (uint32_t)begin;
        }
        frame->stats.facing_away += (uint32_t)end - next;
        next = (uint32_t)end;
    }
    return glint_bin_some(pass, draw, next, draw->count);
}

/* ---- Runs ---- */

static void begin_walk(glint_walk *walk, const glint_mesh *mesh, const glint_transform *transform) {
    walk->cluster = mesh->clusters->list;
    walk->end = 0;
    find_eye(transform, mesh, &walk->eye);
}

static const uint16_t *corners_of_walk(glint_walk *walk, const glint_mesh *mesh, uint32_t triangle) {
    static const uint16_t nowhere[3] = {0, 0, 0};
    while (triangle >= walk->end) {
        face(&walk->eye, walk->cluster, 1, &walk->away);
        walk->end += walk->cluster++->triangles;
    }
    return walk->away ? nowhere : glint_corners_of(walk, mesh, triangle);
}

const glint_cull glint_cull_cones = {check, load, bin, begin_walk, corners_of_walk};
