/* SPDX-License-Identifier: MIT */
/**
 * @file parse_mesh.c
 * Options that say what becomes of a model when it is loaded and converted.
 */
#include "parsers.h"

#include "number.h"
#include "values.h"

#include <string.h>

bool parse_crease(host_settings *settings, const char *text, host_problem *problem) {
    return value_real(text, 0, 180, &settings->load.crease) || value_expected(problem, "takes degrees from 0 to 180");
}

bool parse_weights(host_settings *settings, const char *text, host_problem *problem) {
    for (int i = 0; mesh_weight_names[i] != NULL; i++) {
        if (strcmp(text, mesh_weight_names[i]) == 0) {
            settings->load.weights = (mesh_weights)i;
            return true;
        }
    }
    return value_expected(problem, "takes equal, area or angle");
}

/** The number of a name in a list; -1 for none. */
static int find_name(const char *const *names, const char *text) {
    for (int i = 0; names[i] != NULL; i++) {
        if (strcmp(text, names[i]) == 0) {
            return i;
        }
    }
    return -1;
}

bool parse_positions(host_settings *settings, const char *text, host_problem *problem) {
    const int found = find_name(quantise_position_names, text);
    settings->load.types.positions = (quantise_positions)(found > 0 ? found : 0);
    return found >= 0 || value_expected(problem, "takes int16 or int8");
}

bool parse_normals(host_settings *settings, const char *text, host_problem *problem) {
    const int found = find_name(quantise_normal_names, text);
    settings->load.types.normals = (quantise_normals)(found > 0 ? found : 0);
    return found >= 0 || value_expected(problem, "takes int16, octahedral or octahedral16");
}

bool parse_indices(host_settings *settings, const char *text, host_problem *problem) {
    const int found = find_name(quantise_index_names, text);
    settings->load.types.indices = (quantise_indices)(found > 0 ? found : 0);
    return found >= 0 || value_expected(problem, "takes 16, 8 or auto");
}

bool parse_facets(host_settings *settings, const char *text, host_problem *problem) {
    (void)text;
    (void)problem;
    settings->load.facets = true;
    return true;
}

bool parse_repair(host_settings *settings, const char *text, host_problem *problem) {
    (void)text;
    (void)problem;
    settings->load.repair = true;
    return true;
}

bool parse_weld(host_settings *settings, const char *text, host_problem *problem) {
    return value_real(text, 0, OBJ_COORDINATE_MAX, &settings->load.weld) ||
           value_expected(problem, "takes a distance from 0");
}

static bool parse_count(const char *text, int64_t most, unsigned *count) {
    int64_t value;
    const bool ok = number_integer(text, strlen(text), &value) && value >= 1 && value <= most;
    *count = ok ? (unsigned)value : 0;
    return ok;
}

bool parse_simplify(host_settings *settings, const char *text, host_problem *problem) {
    unsigned count;
    const bool ok = parse_count(text, OBJ_ITEMS_MAX, &count);
    settings->load.simplify = count;
    return ok || value_expected(problem, "takes triangles from 1 to 4000000");
}

bool parse_import_seconds(host_settings *settings, const char *text, host_problem *problem) {
    return parse_count(text, 86400, &settings->load.import.seconds) ||
           value_expected(problem, "takes seconds from 1 to 86400");
}

bool parse_import_memory(host_settings *settings, const char *text, host_problem *problem) {
    return parse_count(text, 1048576, &settings->load.import.megabytes) ||
           value_expected(problem, "takes MB from 1 to 1048576");
}

bool parse_no_clusters(host_settings *settings, const char *text, host_problem *problem) {
    (void)text;
    (void)problem;
    settings->load.plain = true;
    return true;
}

bool parse_panel(host_settings *settings, const char *text, host_problem *problem) {
    const size_t length = strcspn(text, ":");
    char size[16] = "";
    int64_t width = 0;
    int64_t height = 0;
    memcpy(size, text, length < sizeof size ? length : 0);
    if (text[length] == ':') {
        settings->panel.format = framebuffer_find_format(text + length + 1, NULL);
    }
    if (!value_pair(size, &width, &height) || width < 1 || height < 1 || width > GLINT_SIZE_MAX ||
        height > GLINT_SIZE_MAX || settings->panel.format == NULL) {
        return value_expected(problem, "takes WxH[:FORMAT], as in 128x64:grey4; each side from 1 to 1024");
    }
    settings->panel_given = true;
    settings->panel.width = (uint16_t)width;
    settings->panel.height = (uint16_t)height;
    return true;
}

bool parse_name(host_settings *settings, const char *text, host_problem *problem) {
    settings->name = text;
    const size_t plain = strspn(text, "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ_0123456789");
    const bool ok = plain > 0 && text[plain] == '\0' && !(text[0] >= '0' && text[0] <= '9') && plain <= 64;
    return ok || value_expected(problem, "takes a C identifier of at most 64 characters");
}

bool parse_licence(host_settings *settings, const char *text, host_problem *problem) {
    settings->licence = text;
    const size_t plain = strspn(text, "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789 -.+()");
    return (plain > 0 && plain <= 100 && text[plain] == '\0') ||
           value_expected(problem, "takes an SPDX licence expression");
}
