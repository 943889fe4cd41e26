/* SPDX-License-Identifier: MIT */
#include "quantise.h"

#include "basics.h"
#include "values.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#define VERTICES_MAX 65536u

/** What makes vertices different. */
#define VALUES 11

const char *const quantise_position_names[] = {"int16", "int8", NULL};
const char *const quantise_normal_names[] = {"int16", "octahedral", "octahedral16", NULL};
const char *const quantise_index_names[] = {"16", "8", "auto", NULL};

/** Texture coordinates of a material's triangles: none where the first of its ends is above the last. */
typedef struct texture_range {
    double low[2], high[2];
    double offset[2], extent[2]; /* as Q16.16 holds them */
} texture_range;

typedef struct mesh_quantiser {
    const host_mesh *mesh;
    quantise_types types;
    double offset[3], extent[3];
    texture_range *textures; /* of each material */
} mesh_quantiser;

/** A vertex of a piece, and where its corner stood in the mesh. */
typedef struct piece_vertex {
    int16_t values[VALUES]; /* position steps, normal, colour, texture steps */
    mesh_corner corner;
    uint32_t number, slot; /* in order of first use; where it is found */
} piece_vertex;

/** The piece that is being filled. */
typedef struct mesh_piece {
    piece_vertex *vertices;
    uint32_t *slots;     /* vertex number plus one, by hash; 0 for free */
    uint32_t slot_count; /* twice as many as vertices or more: open addressing stays fast half full */
    uint16_t (*triangles)[3];
    size_t vertex_count, vertex_capacity, triangle_count, triangle_capacity;
    uint32_t material;
} mesh_piece;

/* ---- Steps ------------------------------------------------------------------------------------------------------ */

/** Steps from one position that can be stored to the next. */
static int step_size(const mesh_quantiser *quantiser) {
    return quantiser->types.positions == QUANTISE_POSITIONS_INT8 ? 256 : 1;
}

static double last_step(const mesh_quantiser *quantiser) {
    return step_size(quantiser) > 1 ? 127.0 * 256.0 : 32767.0;
}

/** Offset in the middle and an extent by which the last step reaches both ends, both as Q16.16 holds them. */
static void choose_range(double low, double high, double last, double *offset, double *extent) {
    *offset = number_from_q16(number_q16(low / 2 + high / 2));
    const double reach = fmax(high - *offset, *offset - low);
    /* Rounded up, so that the end lies on the last step or below it; exact for what was quantised before. */
    *extent = number_from_q16((glint_q16)ceil(reach * (32768.0 * 65536.0) / last));
}

/** Chooses the range of texture coordinates of each material; the caller frees them. */
static texture_range *choose_textures(const host_mesh *mesh) {
    uint32_t most = 0;
    for (size_t i = 0; i < mesh->triangle_count; i++) {
        most = mesh->materials[i] > most ? mesh->materials[i] : most;
    }
    texture_range *ranges = memory_new((size_t)most + 1, sizeof *ranges);
    for (size_t i = 0; i <= most; i++) {
        ranges[i] = (texture_range){{HUGE_VAL, HUGE_VAL}, {-HUGE_VAL, -HUGE_VAL}, {0, 0}, {0, 0}};
    }
    for (size_t i = 0; i < 3 * mesh->triangle_count; i++) {
        texture_range *range = &ranges[mesh->materials[i / 3]];
        const uint32_t texture = mesh->triangles[i / 3][i % 3].texture;
        for (int axis = 0; texture > 0 && axis < 2; axis++) {
            const double at = mesh->textures[texture - 1][axis];
            const double held = fmax(-QUANTISE_TEXTURE_MAX, fmin(QUANTISE_TEXTURE_MAX, at));
            range->low[axis] = fmin(range->low[axis], held);
            range->high[axis] = fmax(range->high[axis], held);
        }
    }
    for (size_t i = 0; i <= most; i++) {
        for (int axis = 0; ranges[i].low[0] <= ranges[i].high[0] && axis < 2; axis++) {
            choose_range(ranges[i].low[axis], ranges[i].high[axis], 32767, &ranges[i].offset[axis],
                         &ranges[i].extent[axis]);
        }
    }
    return ranges;
}

/* ---- Octahedra (Meyer et al., 2010; Cigolle et al., 2014) ------------------------------------------------------- */

/** What 1 is stored as, and by what the library multiplies that. */
static int octahedron_one(quantise_normals normals) {
    return normals == QUANTISE_NORMALS_OCTAHEDRAL16 ? 32767 : 127;
}

static int octahedron_scale(quantise_normals normals) {
    return normals == QUANTISE_NORMALS_OCTAHEDRAL16 ? 1 : 258;
}

/** x or y of a point whose z is below 0, folded outwards, or back. */
static double fold(double own, double other, double one) {
    return (one - fabs(other)) * (own < 0 ? -1 : 1);
}

static void unfold(double u, double v, double one, double normal[3]) {
    normal[2] = one - fabs(u) - fabs(v);
    normal[0] = normal[2] < 0 ? fold(u, v, one) : u;
    normal[1] = normal[2] < 0 ? fold(v, u, one) : v;
}

static double cosine_between(const double a[3], const double b[3]) {
    const double length = sqrt((a[0] * a[0] + a[1] * a[1] + a[2] * a[2]) * (b[0] * b[0] + b[1] * b[1] + b[2] * b[2]));
    return length > 0 ? (a[0] * b[0] + a[1] * b[1] + a[2] * b[2]) / length : 1;
}

/** The decoded numbers of the nearest normal that can be stored: one of four around the exact place. */
static void choose_octahedral(const double normal[3], quantise_normals type, int16_t values[3]) {
    const double one = octahedron_one(type);
    const double sum = fabs(normal[0]) + fabs(normal[1]) + fabs(normal[2]);
    const double x = sum > 0 ? normal[0] / sum * one : 0;
    const double y = sum > 0 ? normal[1] / sum * one : 0;
    const double place[2] = {normal[2] < 0 ? fold(x, y, one) : x, normal[2] < 0 ? fold(y, x, one) : y};
    double best = -2;
    for (int i = 0; i < 4; i++) {
        const double u = fmin(floor(place[0]) + (i & 1), one);
        const double v = fmin(floor(place[1]) + (i >> 1), one);
        double decoded[3];
        unfold(u, v, one, decoded);
        const double cosine = cosine_between(decoded, normal);
        if (cosine > best) {
            best = cosine;
            for (int axis = 0; axis < 3; axis++) {
                values[axis] = (int16_t)(decoded[axis] * octahedron_scale(type));
            }
        }
    }
}

void quantised_code(const quantised_mesh *mesh, const int16_t normal[3], int code[2]) {
    const double one = octahedron_one(mesh->types.normals);
    const int scale = octahedron_scale(mesh->types.normals);
    const int x = normal[0] / scale;
    const int y = normal[1] / scale;
    code[0] = (int)(normal[2] < 0 ? fold(x, y, one) : x);
    code[1] = (int)(normal[2] < 0 ? fold(y, x, one) : y);
}

/* ---- Corners ---------------------------------------------------------------------------------------------------- */

static int16_t clamp_step(long step) {
    return (int16_t)(step > 32767 ? 32767 : step < -32767 ? -32767 : step);
}

static void quantise_corner(const mesh_quantiser *quantiser, uint32_t material, mesh_corner corner,
                            int16_t values[VALUES]) {
    const int size = step_size(quantiser);
    const texture_range *range = &quantiser->textures[material];
    for (int axis = 0; axis < 2; axis++) {
        const double at = corner.texture > 0 ? quantiser->mesh->textures[corner.texture - 1][axis] : 0;
        const double held = fmax(range->low[axis], fmin(range->high[axis], at));
        values[9 + axis] =
            (int16_t)(range->extent[axis] > 0
                          ? clamp_step(lround((held - range->offset[axis]) / range->extent[axis] * 32768.0))
                          : 0);
    }
    for (int axis = 0; axis < 3; axis++) {
        const double extent = quantiser->extent[axis];
        const double distance = quantiser->mesh->positions[corner.position][axis] - quantiser->offset[axis];
        values[axis] = (int16_t)(extent > 0 ? clamp_step(lround(distance / extent * 32768.0 / size) * size) : 0);
        values[3 + axis] = clamp_step(lround(quantiser->mesh->normals[corner.normal][axis] * 32767.0));
        values[6 + axis] = quantiser->mesh->colours != NULL ? quantiser->mesh->colours[corner.position][axis] : 0;
    }
    if (quantiser->types.normals != QUANTISE_NORMALS_INT16) {
        choose_octahedral(quantiser->mesh->normals[corner.normal], quantiser->types.normals, values + 3);
    }
}

/* ---- Pieces ----------------------------------------------------------------------------------------------------- */

static uint32_t hash_values(const int16_t values[VALUES]) {
    uint32_t hash = 2166136261u;
    for (int i = 0; i < VALUES; i++) {
        hash = (hash ^ (uint16_t)values[i]) * 16777619u;
    }
    return hash ^ hash >> 15;
}

/** The slot that holds a vertex with these values, or the free one where it belongs. */
static uint32_t *find_slot(const mesh_piece *piece, const int16_t values[VALUES]) {
    uint32_t slot = hash_values(values) % piece->slot_count;
    while (piece->slots[slot] != 0 &&
           memcmp(piece->vertices[piece->slots[slot] - 1].values, values, VALUES * sizeof values[0]) != 0) {
        slot = (slot + 1) % piece->slot_count;
    }
    return &piece->slots[slot];
}

static uint16_t place_vertex(mesh_piece *piece, const int16_t values[VALUES], mesh_corner corner) {
    uint32_t *slot = find_slot(piece, values);
    if (*slot == 0) {
        piece->vertices =
            memory_grow(piece->vertices, &piece->vertex_capacity, piece->vertex_count, sizeof *piece->vertices);
        piece_vertex *vertex = &piece->vertices[piece->vertex_count];
        memcpy(vertex->values, values, sizeof vertex->values);
        vertex->corner = corner;
        vertex->number = (uint32_t)piece->vertex_count++;
        vertex->slot = (uint32_t)(slot - piece->slots);
        *slot = (uint32_t)piece->vertex_count;
    }
    return (uint16_t)(*slot - 1);
}

static int compare_vertices(const void *left, const void *right) {
    const piece_vertex *a = left;
    const piece_vertex *b = right;
    if (a->corner.position != b->corner.position) {
        return a->corner.position < b->corner.position ? -1 : 1;
    }
    if (a->corner.normal != b->corner.normal) {
        return a->corner.normal < b->corner.normal ? -1 : 1;
    }
    return (a->corner.texture > b->corner.texture) - (a->corner.texture < b->corner.texture);
}

/** Puts vertices into the order of the mesh and renumbers the triangles. */
static void sort_vertices(mesh_piece *piece) {
    uint16_t *places = memory_new(piece->vertex_count, sizeof *places);
    qsort(piece->vertices, piece->vertex_count, sizeof *piece->vertices, compare_vertices);
    for (size_t i = 0; i < piece->vertex_count; i++) {
        places[piece->vertices[i].number] = (uint16_t)i;
    }
    for (size_t i = 0; i < 3 * piece->triangle_count; i++) {
        uint16_t *index = &piece->triangles[i / 3][i % 3];
        *index = places[*index];
    }
    free(places);
}

/** The colours of a piece's vertices; the caller frees them. */
static const uint8_t (*piece_colours(const mesh_piece *piece))[3] {
    uint8_t(*colours)[3] = memory_new(piece->vertex_count, sizeof *colours);
    for (size_t i = 0; i < 3 * piece->vertex_count; i++) {
        colours[i / 3][i % 3] = (uint8_t)piece->vertices[i / 3].values[6 + i % 3];
    }
    return (const uint8_t(*)[3])colours;
}

/** Gives a mesh the texture coordinates of a piece's vertices, where its material has some. */
static void place_textures(const mesh_quantiser *quantiser, const mesh_piece *piece, glint_mesh *made) {
    const texture_range *range = &quantiser->textures[piece->material];
    if (range->low[0] > range->high[0]) {
        return;
    }
    int16_t(*coordinates)[2] = memory_new(piece->vertex_count, sizeof *coordinates);
    for (size_t i = 0; i < piece->vertex_count; i++) {
        memcpy(coordinates[i], piece->vertices[i].values + 9, sizeof coordinates[i]);
    }
    made->texture_coordinates = (const int16_t(*)[2])coordinates;
    for (int axis = 0; axis < 2; axis++) {
        made->texture_offset[axis] = number_q16(range->offset[axis]);
        made->texture_extent[axis] = number_q16(range->extent[axis]);
    }
}

/** Moves the piece into the result and starts an empty one. */
static void finish_piece(const mesh_quantiser *quantiser, mesh_piece *piece, const glint_mesh *frame,
                         quantised_mesh *out) {
    sort_vertices(piece);
    int16_t(*positions)[3] = memory_new(piece->vertex_count, sizeof *positions);
    int16_t(*normals)[3] = memory_new(piece->vertex_count, sizeof *normals);
    for (size_t i = 0; i < piece->vertex_count; i++) {
        memcpy(positions[i], piece->vertices[i].values, sizeof positions[i]);
        memcpy(normals[i], piece->vertices[i].values + 3, sizeof normals[i]);
    }
    size_t capacity = out->piece_count;
    out->materials = memory_grow(out->materials, &capacity, out->piece_count, sizeof *out->materials);
    capacity = out->piece_count;
    out->pieces = memory_grow(out->pieces, &capacity, out->piece_count, sizeof *out->pieces);
    out->materials[out->piece_count] = piece->material;
    glint_mesh *made = &out->pieces[out->piece_count++];
    *made = *frame;
    made->positions = (const int16_t(*)[3])positions;
    made->normals = (const int16_t(*)[3])normals;
    made->triangles = (const uint16_t(*)[3])piece->triangles;
    made->colours = quantiser->mesh->colours != NULL ? piece_colours(piece) : NULL;
    place_textures(quantiser, piece, made);
    made->vertex_count = (uint32_t)piece->vertex_count;
    made->triangle_count = (uint32_t)piece->triangle_count;
    out->vertex_count += piece->vertex_count;
    out->triangle_count += piece->triangle_count;
    for (size_t i = 0; i < piece->vertex_count; i++) {
        piece->slots[piece->vertices[i].slot] = 0;
    }
    piece->triangles = NULL;
    piece->vertex_count = piece->triangle_count = piece->triangle_capacity = 0;
}

static bool same_position(const int16_t a[VALUES], const int16_t b[VALUES]) {
    return memcmp(a, b, 3 * sizeof a[0]) == 0;
}

/** Adds a triangle to the piece, or to the next when its material is another or its vertices may not fit; or drops it.
 */
static void place_triangle(const mesh_quantiser *quantiser, size_t triangle, mesh_piece *piece, const glint_mesh *frame,
                           quantised_mesh *out) {
    const mesh_corner *corners = quantiser->mesh->triangles[triangle];
    const uint32_t material = quantiser->mesh->materials[triangle];
    int16_t values[3][VALUES];
    for (int i = 0; i < 3; i++) {
        quantise_corner(quantiser, material, corners[i], values[i]);
    }
    if (same_position(values[0], values[1]) || same_position(values[1], values[2]) ||
        same_position(values[2], values[0])) {
        out->dropped_count++;
        return;
    }
    size_t added = 0;
    for (int i = 0; i < 3; i++) {
        added += *find_slot(piece, values[i]) == 0;
    }
    if (piece->triangle_count > 0 && (piece->vertex_count + added > VERTICES_MAX || material != piece->material)) {
        finish_piece(quantiser, piece, frame, out);
    }
    piece->material = material;
    piece->triangles =
        memory_grow(piece->triangles, &piece->triangle_capacity, piece->triangle_count, sizeof *piece->triangles);
    for (int i = 0; i < 3; i++) {
        piece->triangles[piece->triangle_count][i] = place_vertex(piece, values[i], corners[i]);
    }
    piece->triangle_count++;
}

static glint_vector to_q16(const double v[3]) {
    return (glint_vector){number_q16(v[0]), number_q16(v[1]), number_q16(v[2])};
}

/* ---- Public ----------------------------------------------------------------------------------------------------- */

void quantised_position(const glint_mesh *mesh, uint32_t vertex, double position[3]) {
    double extent[3];
    number_from_vector(mesh->offset, position);
    number_from_vector(mesh->extent, extent);
    for (int axis = 0; axis < 3; axis++) {
        position[axis] += extent[axis] * mesh->positions[vertex][axis] / 32768.0;
    }
}

static double sine_between(const double a[3], const double b[3]) {
    const double cross[3] = {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
    const double length = sqrt((a[0] * a[0] + a[1] * a[1] + a[2] * a[2]) * (b[0] * b[0] + b[1] * b[1] + b[2] * b[2]));
    return length > 0 ? sqrt(cross[0] * cross[0] + cross[1] * cross[1] + cross[2] * cross[2]) / length : 0;
}

/** The errors of what is stored. */
static void measure_errors(const mesh_quantiser *quantiser, quantised_mesh *out) {
    double largest = 0;
    double largest_sine = 0; /* of angles below 90 degrees */
    for (size_t i = 0; i < 3 * quantiser->mesh->triangle_count; i++) {
        int16_t values[VALUES];
        const mesh_corner corner = quantiser->mesh->triangles[i / 3][i % 3];
        quantise_corner(quantiser, quantiser->mesh->materials[i / 3], corner, values);
        for (int axis = 0; axis < 3; axis++) {
            const double there = quantiser->offset[axis] + quantiser->extent[axis] * values[axis] / 32768.0;
            largest = fmax(largest, fabs(there - quantiser->mesh->positions[corner.position][axis]));
        }
        const double stored[3] = {values[3], values[4], values[5]};
        largest_sine = fmax(largest_sine, sine_between(stored, quantiser->mesh->normals[corner.normal]));
    }
    out->largest_move = largest;
    out->largest_turn = asin(fmin(largest_sine, 1)) * 57.29577951308232;
}

/** The triangles by rising material, in the order of the mesh where it is the same; the caller frees them. */
static size_t *by_material(const host_mesh *mesh) {
    uint32_t most = 0;
    for (size_t i = 0; i < mesh->triangle_count; i++) {
        most = mesh->materials[i] > most ? mesh->materials[i] : most;
    }
    size_t *starts = memory_new((size_t)most + 2, sizeof *starts);
    for (size_t i = 0; i < mesh->triangle_count; i++) {
        starts[mesh->materials[i] + 1]++;
    }
    for (size_t i = 0; i <= most; i++) {
        starts[i + 1] += starts[i];
    }
    size_t *order = memory_new(mesh->triangle_count, sizeof *order);
    for (size_t i = 0; i < mesh->triangle_count; i++) {
        order[starts[mesh->materials[i]]++] = i;
    }
    free(starts);
    return order;
}

bool quantised_small_indices(const quantised_mesh *mesh, const glint_mesh *piece) {
    return mesh->types.indices != QUANTISE_INDICES_16 && piece->vertex_count <= 256;
}

/** Whether 8 bits hold the indices that are to have them. */
static bool indices_fit(const quantised_mesh *mesh, host_problem *problem) {
    for (size_t i = 0; i < mesh->piece_count && mesh->types.indices == QUANTISE_INDICES_8; i++) {
        if (mesh->pieces[i].vertex_count > 256) {
            return problem_set(problem, 0, "%lu vertices: indices of 8 bits hold 256; auto takes 16 where they must",
                               (unsigned long)mesh->pieces[i].vertex_count);
        }
    }
    return true;
}

/** Whether no piece names its vertices over and over: a frame then takes time by the square of its triangles. */
static bool vertices_differ(const quantised_mesh *mesh, host_problem *problem) {
    for (size_t i = 0; i < mesh->piece_count; i++) {
        const glint_mesh *piece = &mesh->pieces[i];
        if (piece->triangle_count / QUANTISE_SHARING_MAX > piece->vertex_count) {
            return problem_set(problem, 0, "%lu triangles on %lu vertices: more than the %d a vertex that are taken",
                               (unsigned long)piece->triangle_count, (unsigned long)piece->vertex_count,
                               QUANTISE_SHARING_MAX);
        }
    }
    return true;
}

bool quantise(const host_mesh *mesh, uint32_t flags, const quantise_types *types, quantised_mesh *out,
              host_problem *problem) {
    mesh_quantiser quantiser = {.mesh = mesh};
    glint_mesh frame = {.flags = flags};
    double low[3];
    double high[3];
    memset(out, 0, sizeof *out);
    if (types != NULL) {
        quantiser.types = out->types = *types;
    }
    mesh_bounds(mesh, low, high);
    double largest = 0;
    for (int axis = 0; axis < 3; axis++) {
        largest = fmax(largest, fmax(-low[axis], high[axis]));
    }
    if (largest > QUANTISE_COORDINATE_MAX) {
        return problem_set(problem, mesh->farthest_line,
                           "coordinates reach %.6g, beyond the %.0f that fit Q16.16: give --scale fit, or %.2g at most",
                           largest, QUANTISE_COORDINATE_MAX, 0.99 * QUANTISE_COORDINATE_MAX / largest);
    }
    for (int axis = 0; axis < 3; axis++) {
        choose_range(low[axis], high[axis], last_step(&quantiser), &quantiser.offset[axis], &quantiser.extent[axis]);
    }
    frame.offset = to_q16(quantiser.offset);
    frame.extent = to_q16(quantiser.extent);
    quantiser.textures = choose_textures(mesh);
    mesh_piece piece = {.slot_count = 2 * (uint32_t)(mesh->triangle_count < VERTICES_MAX / 3 ? 3 * mesh->triangle_count
                                                                                             : VERTICES_MAX)};
    piece.slots = memory_new(piece.slot_count, sizeof *piece.slots);
    size_t *order = by_material(mesh);
    for (size_t i = 0; i < mesh->triangle_count; i++) {
        place_triangle(&quantiser, order[i], &piece, &frame, out);
    }
    free(order);
    if (piece.triangle_count > 0) {
        finish_piece(&quantiser, &piece, &frame, out);
    }
    free(piece.vertices);
    free(piece.slots);
    measure_errors(&quantiser, out);
    free(quantiser.textures);
    if (!indices_fit(out, problem) || !vertices_differ(out, problem)) {
        quantised_free(out);
        return false;
    }
    return out->piece_count > 0 || problem_set(problem, 0, "all %zu triangles are without area", mesh->triangle_count);
}

void quantised_cluster(quantised_mesh *mesh) {
    for (size_t i = 0; i < mesh->piece_count; i++) {
        cluster_mesh(&mesh->pieces[i]);
    }
}

uint32_t quantised_borrowers(const glint_clusters *clusters) {
    uint32_t count = 0;
    for (uint32_t i = 0; i < clusters->count; i++) {
        count += clusters->list[i].borrowers;
    }
    return count;
}

size_t quantised_size(const quantised_mesh *mesh) {
    static const size_t normal_bytes[] = {6, 2, 4};
    const size_t vertex = (mesh->types.positions == QUANTISE_POSITIONS_INT8 ? 3 : 6) +
                          normal_bytes[mesh->types.normals] + (mesh->pieces[0].colours != NULL ? 3 : 0);
    size_t size = vertex * mesh->vertex_count;
    for (size_t i = 0; i < mesh->piece_count; i++) {
        size += (quantised_small_indices(mesh, &mesh->pieces[i]) ? 3 : 6) * (size_t)mesh->pieces[i].triangle_count;
    }
    for (size_t i = 0; i < mesh->piece_count; i++) {
        const glint_clusters *clusters = mesh->pieces[i].clusters;
        size += mesh->pieces[i].texture_coordinates != NULL ? 4 * (size_t)mesh->pieces[i].vertex_count : 0;
        if (clusters != NULL) {
            size += clusters->count * sizeof *clusters->list;
            size += quantised_borrowers(clusters) * sizeof *clusters->borrowers;
        }
    }
    return size;
}

void quantised_free(quantised_mesh *mesh) {
    for (size_t i = 0; i < mesh->piece_count; i++) {
        /* The library sees them as const; they are this module's own. */
        free((void *)(uintptr_t)mesh->pieces[i].positions);
        free((void *)(uintptr_t)mesh->pieces[i].normals);
        free((void *)(uintptr_t)mesh->pieces[i].triangles);
        free((void *)(uintptr_t)mesh->pieces[i].colours);
        free((void *)(uintptr_t)mesh->pieces[i].texture_coordinates);
        cluster_free(&mesh->pieces[i]);
    }
    free(mesh->pieces);
    free(mesh->materials);
    free(mesh->objects);
    memset(mesh, 0, sizeof *mesh);
}
