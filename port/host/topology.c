/* SPDX-License-Identifier: MIT */
/**
 * @file topology.c
 * Which triangles share which edges, and which way they are wound: flood fill over shared edges, then each part by its
 * signed volume.
 */
#include "mesh.h"

#include "basics.h"

#include <math.h>
#include <stdlib.h>

#define NO_TRIANGLE SIZE_MAX

/** Part of the volume that a part's area could hold below which it counts as flat. */
#define FLAT 1e-6

typedef struct winding_fill {
    const host_mesh *mesh;
    size_t *neighbours; /* 3 for each triangle: the other one at the edge from that corner, or NO_TRIANGLE */
    uint8_t *against;   /* likewise: 1 when the two run along the edge the same way */
    uint8_t *turned;    /* for each triangle: 1 to agree with the first of its part */
    uint8_t *seen;
    size_t *queue; /* the triangles of a part, in the order in which they were reached */
} winding_fill;

/** A part: triangles that hang together by edges that exactly two of them share. */
typedef struct winding_part {
    size_t count;
    size_t against; /* edges along which two triangles disagree as they stand */
    bool closed;
    bool one_sided; /* no way to wind it makes all triangles agree */
} winding_part;

/* ---- Edges ------------------------------------------------------------------------------------------------------ */

static int compare_numbers(size_t a, size_t b) {
    return (a > b) - (a < b);
}

static int compare_edges(const void *left, const void *right) {
    const mesh_half_edge *a = left;
    const mesh_half_edge *b = right;
    int order = compare_numbers(a->low, b->low);
    order = order != 0 ? order : compare_numbers(a->high, b->high);
    order = order != 0 ? order : compare_numbers(a->triangle, b->triangle);
    return order != 0 ? order : a->corner - b->corner;
}

mesh_half_edge *mesh_half_edges(const host_mesh *mesh, const uint32_t *points) {
    const size_t count = 3 * mesh->triangle_count;
    mesh_half_edge *edges = memory_new(count, sizeof *edges);
    for (size_t i = 0; i < count; i++) {
        const uint32_t from = points[mesh->triangles[i / 3][i % 3].position];
        const uint32_t to = points[mesh->triangles[i / 3][(i + 1) % 3].position];
        edges[i].low = from < to ? from : to;
        edges[i].high = from < to ? to : from;
        edges[i].triangle = i / 3;
        edges[i].corner = (int)(i % 3);
        edges[i].forward = from < to;
    }
    qsort(edges, count, sizeof *edges, compare_edges);
    return edges;
}

/** Returns the end of the half edges that share the edge of the one at `first`. */
static size_t edge_end(const mesh_half_edge *edges, size_t first, size_t count) {
    size_t end = first + 1;
    while (end < count && edges[end].low == edges[first].low && edges[end].high == edges[first].high) {
        end++;
    }
    return end;
}

static size_t count_points(const host_mesh *mesh, const uint32_t *points) {
    uint8_t *seen = memory_new(mesh->position_count, 1);
    size_t count = 0;
    for (size_t i = 0; i < 3 * mesh->triangle_count; i++) {
        uint8_t *flag = &seen[points[mesh->triangles[i / 3][i % 3].position]];
        count += *flag == 0;
        *flag = 1;
    }
    free(seen);
    return count;
}

static void count_edge(mesh_topology *topology, const mesh_half_edge *edges, size_t count) {
    if (edges[0].low == edges[0].high) {
        return; /* a triangle without area has edges without length */
    }
    topology->boundary_edges += count == 1;
    topology->shared_edges += count > 2;
    topology->inconsistent_edges += count == 2 && edges[0].forward == edges[1].forward;
}

mesh_topology mesh_check_topology(const host_mesh *mesh) {
    mesh_topology topology = {0, 0, 0, 0};
    uint32_t *points = mesh_weld(mesh);
    mesh_half_edge *edges = mesh_half_edges(mesh, points);
    const size_t count = 3 * mesh->triangle_count;
    for (size_t first = 0, end; first < count; first = end) {
        end = edge_end(edges, first, count);
        count_edge(&topology, edges + first, end - first);
    }
    topology.point_count = count_points(mesh, points);
    free(edges);
    free(points);
    return topology;
}

/* ---- Neighbours ------------------------------------------------------------------------------------------------- */

static bool is_flat(const mesh_corner *triangle, const uint32_t *points) {
    const uint32_t a = points[triangle[0].position];
    const uint32_t b = points[triangle[1].position];
    const uint32_t c = points[triangle[2].position];
    return a == b || b == c || c == a;
}

/** Moves the half edges of triangles with three different points to the front. @return how many they are */
static size_t drop_flat(const host_mesh *mesh, const uint32_t *points, mesh_half_edge *edges) {
    size_t kept = 0;
    for (size_t i = 0; i < 3 * mesh->triangle_count; i++) {
        if (!is_flat(mesh->triangles[edges[i].triangle], points)) {
            edges[kept++] = edges[i];
        }
    }
    return kept;
}

static void join(winding_fill *fill, const mesh_half_edge *edges) {
    for (int i = 0; i < 2; i++) {
        const size_t place = 3 * edges[i].triangle + (size_t)edges[i].corner;
        fill->neighbours[place] = edges[1 - i].triangle;
        fill->against[place] = edges[0].forward == edges[1].forward;
    }
}

static void find_neighbours(winding_fill *fill) {
    uint32_t *points = mesh_weld(fill->mesh);
    mesh_half_edge *edges = mesh_half_edges(fill->mesh, points);
    const size_t count = drop_flat(fill->mesh, points, edges);
    for (size_t i = 0; i < 3 * fill->mesh->triangle_count; i++) {
        fill->neighbours[i] = NO_TRIANGLE;
    }
    for (size_t first = 0, end; first < count; first = end) {
        end = edge_end(edges, first, count);
        if (end - first == 2) {
            join(fill, edges + first);
        }
    }
    free(edges);
    free(points);
}

static winding_fill begin_fill(const host_mesh *mesh) {
    const size_t count = mesh->triangle_count;
    winding_fill fill = {.mesh = mesh};
    fill.neighbours = memory_new(3 * count, sizeof *fill.neighbours);
    fill.against = memory_new(3 * count, 1);
    fill.turned = memory_new(count, 1);
    fill.seen = memory_new(count, 1);
    fill.queue = memory_new(count, sizeof *fill.queue);
    find_neighbours(&fill);
    return fill;
}

static void end_fill(winding_fill *fill) {
    free(fill->neighbours);
    free(fill->against);
    free(fill->turned);
    free(fill->seen);
    free(fill->queue);
}

/* ---- Parts ------------------------------------------------------------------------------------------------------ */

/** Reaches all triangles of the part that `first` belongs to; they stand in the queue then. */
static winding_part fill_part(winding_fill *fill, size_t first) {
    winding_part part = {.count = 1, .closed = true};
    fill->queue[0] = first;
    fill->seen[first] = 1;
    for (size_t done = 0; done < part.count; done++) {
        const size_t triangle = fill->queue[done];
        for (size_t place = 3 * triangle; place < 3 * triangle + 3; place++) {
            const size_t other = fill->neighbours[place];
            if (other == NO_TRIANGLE) {
                part.closed = false;
                continue;
            }
            const uint8_t turned = fill->turned[triangle] ^ fill->against[place];
            part.against += fill->against[place];
            if (fill->seen[other]) {
                part.one_sided = part.one_sided || fill->turned[other] != turned;
                continue;
            }
            fill->seen[other] = 1;
            fill->turned[other] = turned;
            fill->queue[part.count++] = other;
        }
    }
    return part;
}

static void part_centre(const winding_fill *fill, const winding_part *part, double centre[3]) {
    for (int axis = 0; axis < 3; axis++) {
        double low = HUGE_VAL;
        double high = -HUGE_VAL;
        for (size_t i = 0; i < 3 * part->count; i++) {
            const mesh_corner corner = fill->mesh->triangles[fill->queue[i / 3]][i % 3];
            low = fmin(low, fill->mesh->positions[corner.position][axis]);
            high = fmax(high, fill->mesh->positions[corner.position][axis]);
        }
        centre[axis] = low / 2 + high / 2;
    }
}

/**
 * Above 0 when the part, its triangles turned to agree, faces outwards: the volume between it and its middle, six
 * times; where that is too small to tell, the area that need not be turned less the one that must.
 */
static double outwardness(const winding_fill *fill, const winding_part *part) {
    double centre[3];
    double volume = 0;
    double area = 0;
    double kept = 0;
    part_centre(fill, part, centre);
    for (size_t i = 0; i < part->count; i++) {
        const size_t triangle = fill->queue[i];
        const double *corner = fill->mesh->positions[fill->mesh->triangles[triangle][0].position];
        const double sign = fill->turned[triangle] ? -1.0 : 1.0;
        double normal[3];
        mesh_triangle_normal(fill->mesh, triangle, normal);
        const double size = sqrt(normal[0] * normal[0] + normal[1] * normal[1] + normal[2] * normal[2]);
        area += size;
        kept += sign * size;
        for (int axis = 0; axis < 3; axis++) {
            volume += sign * normal[axis] * (corner[axis] - centre[axis]);
        }
    }
    return fabs(volume) > FLAT * area * sqrt(area) ? volume : kept;
}

/* ---- Public ----------------------------------------------------------------------------------------------------- */

mesh_winding mesh_check_winding(const host_mesh *mesh) {
    mesh_winding winding = {0, 0, 0, 0};
    winding_fill fill = begin_fill(mesh);
    for (size_t i = 0; i < mesh->triangle_count; i++) {
        if (fill.seen[i]) {
            continue;
        }
        const winding_part part = fill_part(&fill, i);
        winding.part_count++;
        winding.one_sided_parts += part.one_sided;
        winding.mixed_parts += part.against > 0;
        winding.inward_parts += part.closed && part.against == 0 && outwardness(&fill, &part) < 0;
    }
    end_fill(&fill);
    return winding;
}

void mesh_mark_open(const host_mesh *mesh, bool *marks) {
    winding_fill fill = begin_fill(mesh);
    for (size_t i = 0; i < mesh->triangle_count; i++) {
        if (fill.seen[i]) {
            continue;
        }
        const winding_part part = fill_part(&fill, i);
        if (part.closed && part.against == 0 && outwardness(&fill, &part) >= 0) {
            continue;
        }
        for (size_t j = 0; j < part.count; j++) {
            marks[mesh->materials[fill.queue[j]]] = true;
        }
    }
    end_fill(&fill);
}

/** A corner's own normal, when it came with the model, to the side that its triangle faces now. */
static void turn_normal(host_mesh *mesh, size_t triangle, mesh_corner *corner) {
    double facing[3];
    if (corner->normal == MESH_NO_NORMAL) {
        return;
    }
    mesh_triangle_normal(mesh, triangle, facing);
    const double *given = mesh->normals[corner->normal];
    const double normal[3] = {-given[0], -given[1], -given[2]};
    if (facing[0] * normal[0] + facing[1] * normal[1] + facing[2] * normal[2] > 0) {
        corner->normal = mesh_add_normal(mesh, normal[0], normal[1], normal[2]);
    }
}

static void turn_triangle(host_mesh *mesh, size_t triangle) {
    mesh_corner *corners = mesh->triangles[triangle];
    const mesh_corner second = corners[1];
    corners[1] = corners[2];
    corners[2] = second;
    for (int i = 0; i < 3; i++) {
        turn_normal(mesh, triangle, &corners[i]);
    }
}

size_t mesh_repair_winding(host_mesh *mesh) {
    winding_fill fill = begin_fill(mesh);
    for (size_t i = 0; i < mesh->triangle_count; i++) {
        if (fill.seen[i]) {
            continue;
        }
        const winding_part part = fill_part(&fill, i);
        const bool inward = outwardness(&fill, &part) < 0;
        for (size_t j = 0; j < part.count; j++) {
            uint8_t *turned = &fill.turned[fill.queue[j]];
            *turned = !part.one_sided && *turned != inward;
        }
    }
    size_t count = 0;
    for (size_t i = 0; i < mesh->triangle_count; i++) {
        if (fill.turned[i]) {
            turn_triangle(mesh, i);
            count++;
        }
    }
    end_fill(&fill);
    return count;
}
