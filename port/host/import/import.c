/* SPDX-License-Identifier: MIT */
/**
 * @file import.c
 * glint-import MODEL: what assimp reads, as MTL and OBJ text on stdout: a line `# warning` for each kind of thing that
 * is left out, the materials, a line `# mesh`, the mesh, and `# end`.
 *
 * glint-import --jpeg: a JPEG file on stdin, as pixels on stdout: width and height of 2 bytes each, the higher byte
 * first, and red, green and blue of each pixel, rows from top to bottom.
 *
 * One line on stderr and status 1 for what it cannot read.
 *
 * `glint` runs it in a process of its own, under limits, and trusts nothing that it prints.
 */
#include "import.h"

#include <assimp/cimport.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static int fail(const char *why) {
    fprintf(stderr, "%s\n", why);
    return 1;
}

/** Says whether each face's indices are of its mesh's vertices. All else is checked by the reader of OBJ files. */
static int are_indices_right(const struct aiScene *scene) {
    for (unsigned i = 0; i < scene->mNumMeshes; i++) {
        const struct aiMesh *mesh = scene->mMeshes[i];
        for (unsigned j = 0; j < mesh->mNumFaces; j++) {
            for (unsigned k = 0; k < mesh->mFaces[j].mNumIndices; k++) {
                if (mesh->mFaces[j].mIndices[k] >= mesh->mNumVertices) {
                    return 0;
                }
            }
        }
    }
    return 1;
}

/** What is printed of a scene, mesh by mesh. */
typedef struct printer {
    const struct aiScene *scene;
    int coloured; /* whether any mesh has colours: then all positions get one */
    int painted;  /* whether meshes with a material are printed, or those without */
    size_t position_count, normal_count, texture_count;
} printer;

/** A place in space: 3 rows of 4. */
typedef struct placement {
    double m[3][4];
} placement;

static placement combine(const placement *outer, const struct aiMatrix4x4 *inner) {
    const double rows[4][4] = {{inner->a1, inner->a2, inner->a3, inner->a4},
                               {inner->b1, inner->b2, inner->b3, inner->b4},
                               {inner->c1, inner->c2, inner->c3, inner->c4},
                               {0, 0, 0, 1}};
    placement result;
    for (int row = 0; row < 3; row++) {
        for (int column = 0; column < 4; column++) {
            result.m[row][column] = 0;
            for (int i = 0; i < 4; i++) {
                result.m[row][column] += outer->m[row][i] * rows[i][column];
            }
        }
    }
    return result;
}

/** Computes the cofactors, which take normals as the inverse transpose does. @return the determinant */
static double cofactors(const placement *place, double normal[3][3]) {
    for (int i = 0; i < 3; i++) {
        for (int j = 0; j < 3; j++) {
            const double *a = place->m[(i + 1) % 3];
            const double *b = place->m[(i + 2) % 3];
            normal[i][j] = a[(j + 1) % 3] * b[(j + 2) % 3] - a[(j + 2) % 3] * b[(j + 1) % 3];
        }
    }
    return place->m[0][0] * normal[0][0] + place->m[0][1] * normal[0][1] + place->m[0][2] * normal[0][2];
}

static double channel(float value) {
    return value > 0 ? value < 1 ? (double)value : 1 : 0;
}

static void print_positions(const printer *out, const struct aiMesh *mesh, const placement *place) {
    for (unsigned i = 0; i < mesh->mNumVertices; i++) {
        const struct aiVector3D *at = &mesh->mVertices[i];
        putchar('v');
        for (int row = 0; row < 3; row++) {
            const double *m = place->m[row];
            printf(" %.9g", m[0] * at->x + m[1] * at->y + m[2] * at->z + m[3]);
        }
        const struct aiColor4D *colour = mesh->mColors[0] != NULL ? &mesh->mColors[0][i] : NULL;
        if (colour != NULL) {
            printf(" %.6g %.6g %.6g", channel(colour->r), channel(colour->g), channel(colour->b));
        } else if (out->coloured) {
            printf(" 1 1 1");
        }
        putchar('\n');
    }
}

/** Prints a normal for each position. One that is not finite is printed as none, which is of length 0. */
static void print_normals(const struct aiMesh *mesh, double turn[3][3], double determinant) {
    for (unsigned i = 0; i < mesh->mNumVertices; i++) {
        const struct aiVector3D *at = &mesh->mNormals[i];
        double normal[3];
        int finite = 1;
        for (int row = 0; row < 3; row++) {
            normal[row] = turn[row][0] * at->x + turn[row][1] * at->y + turn[row][2] * at->z;
            normal[row] = determinant < 0 ? -normal[row] : normal[row];
            finite = finite && isfinite(normal[row]);
        }
        printf(finite ? "vn %.9g %.9g %.9g\n" : "vn 0 0 0\n", normal[0], normal[1], normal[2]);
    }
}

/** Returns texture coordinates of a mesh, or null. */
static const struct aiVector3D *textures_of(const struct aiMesh *mesh) {
    return mesh->mNumUVComponents[0] >= 2 ? mesh->mTextureCoords[0] : NULL;
}

static void print_textures(const struct aiMesh *mesh) {
    for (unsigned i = 0; i < mesh->mNumVertices; i++) {
        const struct aiVector3D *at = &textures_of(mesh)[i];
        const int finite = isfinite(at->x) && isfinite(at->y);
        printf("vt %.9g %.9g\n", finite ? (double)at->x : 0, finite ? (double)at->y : 0);
    }
}

/** Prints a face, the other way round where its mesh is mirrored. Points and lines are told from faces by their letter.
 */
static void print_face(const printer *out, const struct aiMesh *mesh, const struct aiFace *face, int mirrored) {
    putchar(face->mNumIndices > 2 ? 'f' : face->mNumIndices == 2 ? 'l' : 'p');
    for (unsigned i = 0; i < face->mNumIndices; i++) {
        const size_t index = face->mIndices[mirrored ? face->mNumIndices - 1 - i : i];
        printf(" %zu", out->position_count + index + 1);
        if (face->mNumIndices <= 2) {
            continue;
        }
        if (textures_of(mesh) != NULL) {
            printf("/%zu", out->texture_count + index + 1);
        }
        if (mesh->mNormals != NULL) {
            printf(textures_of(mesh) != NULL ? "/%zu" : "//%zu", out->normal_count + index + 1);
        }
    }
    putchar('\n');
}

static void print_mesh(printer *out, const struct aiMesh *mesh, const placement *place) {
    double turn[3][3];
    const double determinant = cofactors(place, turn);
    print_positions(out, mesh, place);
    if (mesh->mNormals != NULL) {
        print_normals(mesh, turn, determinant);
    }
    if (textures_of(mesh) != NULL) {
        print_textures(mesh);
    }
    if (out->painted) {
        paint_use(out->scene, mesh->mMaterialIndex);
    }
    for (unsigned i = 0; i < mesh->mNumFaces; i++) {
        print_face(out, mesh, &mesh->mFaces[i], determinant < 0);
    }
    out->position_count += mesh->mNumVertices;
    out->normal_count += mesh->mNormals != NULL ? mesh->mNumVertices : 0;
    out->texture_count += textures_of(mesh) != NULL ? mesh->mNumVertices : 0;
}

/** Prints a node's meshes as an object with the node's name. */
static void print_meshes(printer *out, const struct aiNode *node, const placement *place) {
    struct aiString name = node->mName;
    paint_plain(&name);
    if (node->mNumMeshes > 0) {
        printf("o %s\n", name.data);
    }
    for (unsigned i = 0; i < node->mNumMeshes; i++) {
        const unsigned number = node->mMeshes[i];
        const struct aiMesh *mesh = number < out->scene->mNumMeshes ? out->scene->mMeshes[number] : NULL;
        if (mesh != NULL && paint_is_none(out->scene, mesh->mMaterialIndex) == !out->painted) {
            print_mesh(out, mesh, place);
        }
    }
}

/** A node that is still to be printed, and where what is above it puts it. */
typedef struct waiting_node {
    const struct aiNode *node;
    placement above;
} waiting_node;

/** Makes room for `more` of them, or ends the program. */
static waiting_node *reserve(waiting_node *list, size_t *capacity, size_t count, size_t more) {
    if (count + more > *capacity) {
        *capacity = 2 * (count + more);
        list = realloc(list, *capacity * sizeof *list);
    }
    if (list == NULL) {
        exit(fail("takes more memory than it may"));
    }
    return list;
}

/** Prints the meshes of all nodes: a node before what is below it, in the order of the file. */
static void print_nodes(printer *out) {
    static const placement here = {{{1, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, 1, 0}}};
    size_t capacity = 0;
    size_t count = 1;
    waiting_node *waiting = reserve(NULL, &capacity, 0, 1);
    waiting[0].node = out->scene->mRootNode;
    waiting[0].above = here;
    while (count > 0) {
        const waiting_node first = waiting[--count];
        const placement place = combine(&first.above, &first.node->mTransformation);
        print_meshes(out, first.node, &place);
        waiting = reserve(waiting, &capacity, count, first.node->mNumChildren);
        for (unsigned i = first.node->mNumChildren; i-- > 0;) {
            waiting[count].node = first.node->mChildren[i];
            waiting[count++].above = place;
        }
    }
    free(waiting);
}

/** Prints a line for what the file has and the mesh has not. */
static void print_skipped(const char *what, unsigned count) {
    if (count > 0) {
        printf("# warning %s are skipped (%u)\n", what, count);
    }
}

static void print_scene(const struct aiScene *scene) {
    printer out = {scene, 0, 0, 0, 0, 0};
    unsigned skinned = 0;
    for (unsigned i = 0; i < scene->mNumMeshes; i++) {
        skinned += scene->mMeshes[i]->mNumBones > 0;
    }
    print_skipped("animations", scene->mNumAnimations);
    print_skipped("cameras", scene->mNumCameras);
    print_skipped("lights", scene->mNumLights);
    print_skipped("skins", skinned);
    for (unsigned i = 0; i < scene->mNumMeshes; i++) {
        out.coloured = out.coloured || scene->mMeshes[i]->mColors[0] != NULL;
    }
    paint_print(scene);
    puts("# mesh");
    /* What has no material comes first: nothing in an OBJ file ends a usemtl. */
    print_nodes(&out);
    out.painted = 1;
    print_nodes(&out);
    puts("# end");
}

int main(int count, char **arguments) {
    struct aiFileIO files;
    if (count != 2) {
        return fail("usage: glint-import MODEL, or glint-import --jpeg");
    }
    if (strcmp(arguments[1], "--jpeg") == 0) {
        const char *why = jpeg_print();
        return why == NULL ? 0 : fail(why);
    }
    if (!folder_open(&files, arguments[1])) {
        return fail("its folder cannot be opened");
    }
    /* assimp could check all of it, and would refuse a mesh for an animation, a bone or a camera that is not drawn. */
    const struct aiScene *scene = aiImportFileEx(arguments[1], 0, &files);
    if (scene == NULL) {
        const char *why = aiGetErrorString();
        return fail(strstr(why, "bad_alloc") != NULL ? "takes more memory than it may" : why);
    }
    if (scene->mRootNode == NULL || !are_indices_right(scene)) {
        return fail("a face names a vertex that is not there");
    }
    print_scene(scene);
    return fflush(stdout) == 0 ? 0 : fail("its output cannot be written");
}
