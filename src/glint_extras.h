/* SPDX-License-Identifier: MIT */
/**
 * @file glint_extras.h
 * This header has what a first program does without: generated meshes, layouts of meshes, a check that tells why a
 * picture is black, points of the screen, lines, tiles that did not change, frames drawn tile by tile. The conventions
 * are those of glint.h. A program links what it calls and nothing else.
 */

#ifndef GLINT_EXTRAS_H
#define GLINT_EXTRAS_H

#include "glint.h"

#ifdef __cplusplus
extern "C" {
#endif

/* ---- Generated meshes -------------------------------------------------------------------------------------------- */

/** This is where a generator writes. The caller owns it, and keeps it as long as the mesh. */
typedef struct glint_mesh_room {
    int16_t (*positions)[3];             /**< Room for vertex_room. */
    int16_t (*normals)[3];               /**< Room for vertex_room. */
    uint16_t (*triangles)[3];            /**< Room for triangle_room. */
    uint32_t vertex_room, triangle_room; /**< How many fit. */
} glint_mesh_room;

/**
 * @name Generators
 * Each fills `room` with a surface and its normals, both from the formula, and sets `mesh` up to point there. They
 * return GLINT_ERROR_GENERATOR when a size is not above 0, when there are fewer divisions than a solid needs or more
 * vertices than uint16 can index, or when the room is too small: then mesh->vertex_count and mesh->triangle_count tell
 * how much it takes, and the rest of the mesh is as it was. Sizes are Q16.16, up to 8192.
 * @{
 */

/**
 * Generates a torus around the z axis.
 * @param mesh,room as above
 * @param around,along quads, 3 or more
 * @param radius to the tube's centre
 * @param tube the tube's own
 * @return as above
 */
glint_status glint_generate_torus(glint_mesh *mesh, const glint_mesh_room *room, uint32_t around, uint32_t along,
                                  glint_q16 radius, glint_q16 tube);

/**
 * Generates a sphere whose poles lie on z.
 * @param mesh,room as above
 * @param around quads, 3 or more
 * @param along steps from pole to pole, 2 or more
 * @param radius its own
 * @return as above
 */
glint_status glint_generate_sphere(glint_mesh *mesh, const glint_mesh_room *room, uint32_t around, uint32_t along,
                                   glint_q16 radius);

/**
 * Generates a cylinder around the z axis, from -half_height to half_height.
 * @param mesh,room as above
 * @param around quads, 3 or more
 * @param along steps, 1 or more
 * @param radius,half_height its size
 * @param capped 0 where it is open
 * @return as above
 */
glint_status glint_generate_cylinder(glint_mesh *mesh, const glint_mesh_room *room, uint32_t around, uint32_t along,
                                     glint_q16 radius, glint_q16 half_height, int capped);

/**
 * Generates a cone around the z axis, with its base at -half_height and its tip at half_height.
 * @param mesh,room as above
 * @param around quads, 3 or more
 * @param along steps, 1 or more
 * @param radius,half_height its size
 * @param capped 0 where its base is open
 * @return as above
 */
glint_status glint_generate_cone(glint_mesh *mesh, const glint_mesh_room *room, uint32_t around, uint32_t along,
                                 glint_q16 radius, glint_q16 half_height, int capped);

/**
 * Generates a rectangle in the plane z = 0, seen from +z.
 * @param mesh,room as above
 * @param columns,rows quads, 1 or more
 * @param half_width,half_height x and y are from minus to plus these
 * @return as above
 */
glint_status glint_generate_plane(glint_mesh *mesh, const glint_mesh_room *room, uint32_t columns, uint32_t rows,
                                  glint_q16 half_width, glint_q16 half_height);

/**
 * Generates a box of six faces, each with vertices of its own: 24 vertices, 12 triangles.
 * @param mesh,room as above
 * @param half_width,half_height,half_depth its size
 * @return as above
 */
glint_status glint_generate_box(glint_mesh *mesh, const glint_mesh_room *room, glint_q16 half_width,
                                glint_q16 half_height, glint_q16 half_depth);
/** @} */

/* ---- Layouts of meshes ------------------------------------------------------------------------------------------- */

/*
 * A layout stores attributes of a mesh in fewer bits than its arrays do, or in structs of the caller's. Firmware that
 * names no type of these has no code for them.
 */

/** An attribute type says how an attribute is stored. It is one of the descriptors below. Numbers are in the machine's
 * own byte order. */
typedef struct glint_attribute_type glint_attribute_type;

/** Positions are three int16, steps. Normals are three int16, any length but 0. Both have 6 bytes, aligned to 2. */
extern const glint_attribute_type glint_attribute_int16;

/** Positions are three int8, each 256 steps. Normals are three int8, any length but 0. Both have 3 bytes. */
extern const glint_attribute_type glint_attribute_int8;

/**
 * Normals are x and y of the octahedron |x| + |y| + |z| = 1, whose half with z < 0 is folded outwards onto a square
 * (Meyer et al., 2010; Cigolle et al., 2014). They are two int16, 32767 for 1, -32768 as -32767: 4 bytes, aligned to 2.
 * They are decoded exactly, except for the length. No direction is more than 0.0025 degrees from the nearest one
 * stored.
 */
extern const glint_attribute_type glint_attribute_octahedral16;

/** Normals of the octahedron are two int8, 127 for 1, -128 as -127: 2 bytes. No direction is more than 0.64 degrees
 * from the nearest. */
extern const glint_attribute_type glint_attribute_octahedral8;

/** Triangles are three uint16: 6 bytes, aligned to 2. */
extern const glint_attribute_type glint_attribute_uint16;

/** Triangles are three uint8, for up to 256 vertices: 3 bytes. */
extern const glint_attribute_type glint_attribute_uint8;

/** Colours are red, green and blue times 255: 3 bytes. */
extern const glint_attribute_type glint_attribute_rgb888;

/** Colours are RGB565: 2 bytes, aligned to 2. */
extern const glint_attribute_type glint_attribute_rgb565;

/** An attribute of a mesh is stored here. */
typedef struct glint_mesh_attribute {
    const glint_attribute_type *type; /**< Null for none. */
    const void *data;                 /**< The first vertex's, or triangle's. */
    uint32_t stride;                  /**< Bytes from one to the next; 0: one follows the other. */
} glint_mesh_attribute;

/**
 * A layout has attributes in place of those arrays of a mesh that are null. Positions, normals and colours are decoded
 * when they are used; triangles use 6 bytes of arena each while their mesh is drawn whole. The caller owns a layout, as
 * it owns arrays.
 */
struct glint_mesh_layout {
    glint_mesh_attribute positions; /**< glint_attribute_int16 or _int8. */
    glint_mesh_attribute normals;   /**< glint_attribute_int16, _int8, _octahedral8 or _octahedral16. */
    glint_mesh_attribute triangles; /**< glint_attribute_uint16 or _uint8. */
    glint_mesh_attribute colours;   /**< glint_attribute_rgb888 or _rgb565; used where both arrays of colours are
                                         null. */
};

/* ---- Why a picture is black -------------------------------------------------------------------------------------- */

/** This is what glint_check found. */
typedef struct glint_report {
    glint_status status;  /**< What drawing the scene returns. */
    const char *sentence; /**< In English, what is wrong or looks wrong; "" where nothing does. Never null. */
    int32_t object;       /**< The object that it is about, or -1. */
    int32_t light;        /**< The light that it is about, or -1. */
    size_t bytes;         /**< How many bytes of arena, or of pixels, are missing; else 0. */
    uint32_t shown;       /**< Pixels of the region that show an object, those that are blended aside, where the scene
                               can be drawn. */
} glint_report;

/**
 * Looks for what keeps a scene from being drawn, or makes it black. It draws the scene with the configuration's arena,
 * and sends nothing. It is for development: neither its time nor its flash is meant for a product. It must not be
 * called while a frame is being drawn.
 * @param config,scene what is to be drawn
 * @param report what was found
 * @return report->status, or GLINT_ERROR_NULL where `report` is null
 */
glint_status glint_check(const glint_config *config, const glint_scene *scene, glint_report *report);

/* ---- From the screen to the scene, and back ---------------------------------------------------------------------- */

/** A screen point says where a point is visible on the screen. */
typedef struct glint_screen_point {
    glint_q16 x, y;     /**< Pixels from the screen's left and top edge; saturated. */
    glint_q16 distance; /**< From the eye along the camera's axis; saturated. */
} glint_screen_point;

/**
 * Finds where a point of the world is visible on a screen of config->width and height. It is off by at most 1/128 of a
 * pixel, on and around the screen. Nothing else of the configuration is read.
 * @param config,camera what it is seen with
 * @param point in the world
 * @param to where it is visible
 * @return 1, 0 when it lies in front of the near plane: then `to` is as it was; GLINT_ERROR_NULL, _SIZE or _CAMERA
 */
int glint_camera_project(const glint_config *config, const glint_camera *camera, glint_vector point,
                         glint_screen_point *to);

/** A hit says what a pixel shows. */
typedef struct glint_hit {
    uint32_t object;   /**< Of the scene. */
    uint32_t triangle; /**< Of the object's mesh. */
    uint16_t depth;    /**< As glint_tile has it: larger is nearer. */
} glint_hit;

/**
 * Finds which triangle glint_render shows at a pixel of the screen, by drawing that pixel. It uses the renderer's
 * arena, and must not be called while a frame is being drawn.
 * @param renderer,scene what shows
 * @param x,y the pixel
 * @param hit what it shows
 * @return 1, 0 when it shows background: then `hit` is as it was; GLINT_ERROR_REGION when the pixel is not on the
 * screen, or an error of the scene
 */
int glint_pick(glint_renderer *renderer, const glint_scene *scene, int x, int y, glint_hit *hit);

/* ---- What is not opaque ------------------------------------------------------------------------------------------ */

/**
 * Layers draw objects that blend: `config.layers = &glint_layers`. Each tile then has its pixels and its depth twice,
 * and what links them is in the program.
 *
 * An object that blends shows its nearest surface, of a closed mesh too, over what was drawn before it, and writes no
 * depth. Objects of GLINT_BLEND_ALPHA and GLINT_BLEND_ADD are drawn after all others: by rising glint_object.order, of
 * the same order from back to front by how far the middles of their meshes' boxes lie from the eye along the camera's
 * axis, of the same depth as the scene has them. Objects of GLINT_BLEND_DITHERED are drawn with opaque ones, in any
 * order, and write depth where they cover pixels: these whose threshold of ordered dithering, an odd number of 128ths,
 * is below the opacity.
 *
 * Pixels are blended as they are stored, after output tables: (1 - a) old + a new, or old + a new and at most white, in
 * levels of the format. The opacity a counts in steps of 1/256, in formats of 16 bits of 1/32. Dithered formats add
 * their threshold, others half a level.
 */
extern const glint_layer_stage glint_layers;

/** A fog type says how fog grows with depth. It is one of the descriptors below. */
typedef struct glint_fog_type glint_fog_type;

/** Let x be (depth - start) / (end - start), from 0 to 1: x of a surface's colour is fog. */
extern const glint_fog_type glint_fog_linear;

/** x^2 of a surface's colour is fog: it begins slowly. */
extern const glint_fog_type glint_fog_squared;

/**
 * Fog fades surfaces to a colour by their depth, which is along the camera's axis. Of additive objects it takes light;
 * those of GLINT_BLEND_ALPHA lose opacity where it fades to a painted background. Backgrounds have no fog. The caller
 * owns it.
 */
struct glint_fog {
    const glint_fog_type *type; /**< How it grows. */
    glint_colour colour;        /**< What it fades to, from 0 to GLINT_COLOUR_MAX. */
    glint_q16 start, end;       /**< Depths: 0 <= start < end. */
    uint8_t to_background;      /**< Not 0: it fades to the background, painted (glint_config.layers) or not, in place
                                     of the colour. */
};

/**
 * Each pixel is the mean of 2 x 2 samples, which lie a quarter of a pixel from its middle in x and y, as they are
 * stored and rounded; dithered formats dither samples, and their means by 64 thresholds over 8 x 8 pixels. Width and
 * height are at most 512, those of tiles 32. A tile's depth and pixels, `glint_config.pixels` too, have four times the
 * size. A background's painter paints pixels, whose samples are alike. Overlays are painted over means, and see the
 * depth of the nearest sample; where there is no overlay, glint_tile.depth is of no use.
 */
extern const glint_sampling glint_samples_2x2;

/* ---- Lines ------------------------------------------------------------------------------------------------------- */

/*
 * Straight lines in space: edges, axes, boxes. Each is of one colour, which no light changes, and is hidden by what
 * lies in front of it. They are projected to the screen before a frame, and drawn by its overlay, one pixel wide or
 * smooth:
 *
 *     glint_lines_project(segments, &config, &scene.camera, &pose, lines, count);    // and then glint_render
 *     int paint(void *context, const glint_tile *tile) { return glint_lines_draw(tile, segments, count); }
 *
 * A line ends where it passes the near plane or lies 1023 pixels from the screen's centre in x or y. Its ends are then
 * rounded to 1/16 of a pixel. Without smoothing, a line that is at least as wide as it is high has one pixel in each
 * column, from that of its left end to that of its right end, both included: the pixel that holds the point where the
 * line passes the middle of the column or, where it ends before, its end. A steeper line has one pixel in each row,
 * likewise. A point between two pixels belongs to the right or the lower one. The same pixels come from both
 * directions, and for every tile, arena and region.
 *
 * A pixel's depth is that of this point, linear between the ends as that of a triangle is, and is tested and stored as
 * a triangle's is: a later line lies in front where it is nearer. A line counts as nearer to the eye than it is, by
 * the width of two pixels there, so that it is visible on a surface that it lies on, unless that surface leans by more
 * than 75 degrees. Lines do not count where the depth's scale is found: of lines in front of all objects none is
 * nearer than another, and where there are no objects, only the order counts.
 *
 * A smooth line is a rectangle of its width, cut straight across at its ends. It is blended with what is there by how
 * much of a square of one pixel it covers, that lies around the pixel's middle and is turned along the line: min(1,
 * size, size / 2 + 1/2 - distance) of its length and of its width, multiplied, to 1/128. A smooth line writes no depth:
 * what is drawn after it lies in front of it.
 */

/** A line is owned by the caller. */
typedef struct glint_line {
    glint_vector from, to; /**< Before the pose. */
    glint_colour colour;   /**< Each channel from 0 to GLINT_COLOUR_MAX. */
    glint_q16 width;       /**< Of a smooth line: pixels, 0 to 64; 0 for 1. */
} glint_line;

/** A segment is a line on the screen. The caller owns it; only glint_lines_project writes it. */
typedef struct glint_segment {
    /** @privatesection */
    int16_t x[2], y[2];    /* its ends, 28.4 */
    uint32_t inverse_w[2]; /* there: 1/w, w in Q28, is this over 2^exponent */
    uint8_t exponent[2];
    uint16_t width;             /* 1/256 pixel */
    const glint_colour *colour; /* null where nothing of it shows */
} glint_segment;

/**
 * Projects lines to the screen of a configuration, whose width and height count. Ends are first taken to the world,
 * each coordinate rounded to nearest and saturated as glint_pose_apply does. They are then off by at most 1/64 of a
 * pixel, on and around the screen, before they are rounded.
 * @param segments `count` of them; like the lines, whose colours they point to, they stay until the frame is drawn
 * @param config,camera what they are seen with
 * @param pose of the lines, to the world
 * @param lines `count` of them
 * @param count how many
 * @return GLINT_ERROR_NULL, _SIZE, _CAMERA, _COLOUR or _WIDTH: then segments are as they were
 */
glint_status glint_lines_project(glint_segment *segments, const glint_config *config, const glint_camera *camera,
                                 const glint_pose *pose, const glint_line *lines, uint32_t count);

/**
 * Draws lines on a finished tile, for an overlay. Calls follow each other: lines of an earlier call hide what is drawn
 * behind them. Tiles of one frame may be drawn by several callers at once.
 * @param tile what the overlay is given
 * @param segments `count` of them, projected
 * @param count how many
 * @return GLINT_OK, or GLINT_ERROR_NULL where there is no tile, or not one that a frame has handed out
 */
glint_status glint_lines_draw(const glint_tile *tile, const glint_segment *segments, uint32_t count);

/** Draws smooth lines in the same way. @param tile,segments,count as for glint_lines_draw @return as it does */
glint_status glint_lines_draw_smooth(const glint_tile *tile, const glint_segment *segments, uint32_t count);

/** Sets the twelve edges of a box. @param lines set @param from,to opposite corners @param colour of all */
void glint_lines_box(glint_line lines[12], glint_vector from, glint_vector to, glint_colour colour);

/**
 * Sets lines to the edges of a mesh, in object space, rounded to nearest and saturated. An edge of two triangles that
 * name the same two vertices is set once, an edge with a vertex that the mesh does not have is left out. This is for
 * meshes of a few hundred triangles: its time grows with their square.
 * @param lines set
 * @param room how many fit in `lines`, which may be null where it is 0
 * @param mesh whose edges; with all that glint_render asks of it but for indices
 * @param colour of all
 * @return how many edges there are; those beyond `room` are left out
 */
uint32_t glint_lines_edges(glint_line *lines, uint32_t room, const glint_mesh *mesh, glint_colour colour);

/* ---- Only what changed ------------------------------------------------------------------------------------------- */

/*
 * A panel keeps its picture: unchanged tiles need not be sent. A filter between the renderer and the panel's flush
 * knows each tile by a signature of 64 bits, 8 bytes a tile of the caller's memory. Different tiles have the same
 * signature with a chance of 2^-64; tiles that differ in four bytes only never have.
 *
 *     static glint_tile_signature signatures[80];               // glint_tile_signature_count(&config)
 *     glint_change_filter_init(&filter, signatures, &config);
 *     config.flush = glint_change_filter_flush(&filter);        // and then glint_init
 *
 * Tile size, format and arena are the configuration's own. A tile's pixels are aligned to 4 bytes, as the renderer
 * aligns them.
 */

/** A signature identifies the pixels that a tile was sent with; 0 for a tile that has yet to be sent. */
typedef struct glint_tile_signature {
    /** @privatesection */
    uint32_t a, b;
} glint_tile_signature;

/** A filter lets only changed tiles pass to the panel. The caller owns it. */
typedef struct glint_change_filter {
    uint32_t sent, unchanged; /**< Tiles, since glint_change_filter_init. */
    /** @privatesection */
    glint_flush flush;
    glint_tile_signature *signatures, *sending, pending;
    uint32_t count;
    uint16_t columns, tile_width, tile_height, width, height;
    int16_t left, top;
    uint8_t is_part; /* is a part of a tile on its way? */
} glint_change_filter;

/** Returns how many signatures a configuration needs. @param config with which is drawn @return 0 when it is null or
 * not valid */
uint32_t glint_tile_signature_count(const glint_config *config);

/**
 * Sets a filter up before config->flush; all tiles have yet to be sent. On failure the filter, if there is one, is all
 * 0, and so is its flush, which glint_init refuses.
 * @param filter the filter
 * @param signatures glint_tile_signature_count of them, the caller's as long as the filter
 * @param config with which is to be drawn, its flush that of the panel
 * @return GLINT_ERROR_NULL, _SIZE or _TILE.
 */
glint_status glint_change_filter_init(glint_change_filter *filter, glint_tile_signature *signatures,
                                      const glint_config *config);

/**
 * Sends all tiles again, for a panel that was restarted. A tile whose flush failed is sent again anyhow.
 * @param filter the filter
 */
void glint_change_filter_forget(glint_change_filter *filter);

/** Returns the flush to draw with. @param filter the filter, which must outlive it @return the flush */
glint_flush glint_change_filter_flush(glint_change_filter *filter);

/* ---- Tile by tile ------------------------------------------------------------------------------------------------ */

/*
 * glint_render is a loop over these functions. Use them to draw the tiles of a frame in another order, or on two cores:
 *
 *     glint_frame_begin(&frame, &config, &scene);
 *     while ((status = glint_frame_next_pass(&frame)) > 0)      // a pass
 *         for (tile = frame.tile_first; tile < frame.tile_end; tile++)
 *             if (glint_render_tile(&frame, &workspace, tile))  // any number of callers at once
 *                 send it, glint_tile_find says where;
 */

/** Memory is handed out from both ends. The bytes from `low` to `high` are free. */
typedef struct glint_memory {
    /** @privatesection */
    uint8_t *base;
    size_t low, high;
} glint_memory;

/** A frame holds everything that drawing the tiles of a pass reads. Only glint_frame_begin and glint_frame_next_pass
 * write it. */
typedef struct glint_frame {
    uint16_t tile_first, tile_end; /**< Tiles of this pass: from the first to before the end. */
    glint_stats stats;             /**< So far. */
    /** @privatesection */
    glint_config config;
    const glint_scene *scene;
    const struct glint_view *view;       /* camera and lights, prepared */
    const struct glint_shading *shading; /* materials, prepared */
    const uint32_t *order;               /* of layers: the objects in the order in which they are drawn; or null */
    const struct glint_fog_table *fog;   /* of use where the scene has fog */
    uint32_t shading_count;
    glint_memory memory;
    uint16_t tile_columns, tile_count;   /* of the region */
    uint16_t first_column, first_row;    /* of the screen's tiles, in the region */
    uint16_t right, bottom;              /* behind the region's last pixels */
    uint16_t pass_tiles;                 /* tiles that a pass may hold */
    uint16_t loaded_end;                 /* what is loaded is for tiles before this */
    uint8_t tile_shift_x, tile_shift_y;  /* binary logarithms of the tile's size */
    uint8_t starts, ends;                /* the pass holds the scene's first triangle, its last */
    uint8_t covers_end;                  /* what is loaded reaches the scene's end */
    uint8_t resident;                    /* what is loaded is all of the scene */
    uint8_t has_extents;                 /* they have been looked for */
    uint8_t extent_shift;                /* binary logarithm of the triangles of an extent */
    const struct glint_extent *extents;  /* null where all is loaded, or there is no room for them */
    uint32_t object, triangle;           /* where the next pass goes on */
    size_t prepared_end, vertices_end;   /* of the arena's use */
    size_t part_bytes;                   /* about what a triangle that may show takes, where parts are loaded */
    uint32_t waiting;                    /* transforms of the last objects that wait to be loaded */
    size_t least_room;                   /* of the arena, behind what is prepared */
    struct glint_corner_lights *corners; /* the lights of one object's corners; null where none are lit */
    struct glint_draw *draws;            /* what this pass draws */
    struct glint_reference *references;  /* first one for each of its tiles, with which the tile's list begins */
    uint32_t reference_count;
    uint8_t has_costly;            /* does this pass draw what is lit by fragments? */
    struct glint_clipped *clipped; /* above the last; they grow downwards */
    const glint_sampling *samples; /* null for one sample a pixel; else all else here counts samples as pixels */
    uint8_t has_long_slopes;       /* see src/pixel/format.h */
} glint_frame;

/** Scratch bytes of the arena are left free by a pass. One of its tiles stores results there, and others use them. */
typedef struct glint_spare {
    /** @privatesection */
    void *memory; /* aligned as the arena; null where there are none */
    uint32_t size;
    uint32_t is_begun; /* not 0: something of this pass is there */
} glint_spare;

/** A workspace holds what drawing one tile needs. */
typedef struct glint_workspace {
    void *pixels;  /**< The finished tile. */
    size_t stride; /**< Bytes from row to row. */
    /** @privatesection */
    uint16_t *depth;
    int32_t (*row)[3];           /* colours of two rows of a tile; of use as long as nothing is drawn */
    struct glint_lamps *lamps;   /* in the same place: the lights of what is drawn now */
    struct glint_lit_room *room; /* behind them: the triangle that is drawn now */
    glint_spare spare;
    struct glint_layer *layer; /* behind the room; of use where the configuration has layers */
} glint_workspace;

/** Returns the bytes of a workspace. @param config with which is drawn @return 0 when it is null or not valid */
size_t glint_workspace_size(const glint_config *config);

/**
 * Lays a workspace out.
 * @param workspace set
 * @param config with which is drawn
 * @param memory of glint_workspace_size bytes, which are not 0, aligned as a pointer is
 */
void glint_workspace_init(glint_workspace *workspace, const glint_config *config, void *memory);

/**
 * Begins a frame: checks the scene and prepares camera, lights and materials in the arena, all of which it may use. On
 * failure the frame, if there is one, is all 0.
 * @param frame where config->keeps_arena is set, the last one drawn with this configuration, or all 0; else anything
 * @param config how to draw; copied
 * @param scene what to draw; it stays until the frame is done
 * @return GLINT_OK, or why the frame cannot be drawn
 */
glint_status glint_frame_begin(glint_frame *frame, const glint_config *config, const glint_scene *scene);

/** Prepares the next pass. @param frame begun @return 1 when there is one, 0 when the frame is done, or an error. */
int glint_frame_next_pass(glint_frame *frame);

/**
 * Draws the part of a tile that this pass holds, from frame->tile_first to frame->tile_end - 1. It reads the frame and
 * writes the workspace and the tile's own list: callers with workspaces of their own may draw different tiles of one
 * pass at the same time. A tile that needs several passes must be drawn into the same workspace in each.
 * @param frame a pass is prepared of
 * @param workspace where it is drawn
 * @param tile its number
 * @return 1 when the tile is finished, 0 when a later pass adds to it, or GLINT_ERROR_PAINT.
 */
int glint_render_tile(const glint_frame *frame, glint_workspace *workspace, uint32_t tile);

/**
 * Finds where a tile lies on the screen, in pixels, cut at the screen's edges and at the region's.
 * @param frame of which it is
 * @param tile its number
 * @param x,y,width,height set
 */
void glint_tile_rectangle(const glint_frame *frame, uint32_t tile, int *x, int *y, int *width, int *height);

/**
 * Finds a tile with its pixels and its depth.
 * @param frame of which it is
 * @param workspace that holds it
 * @param tile its number
 * @param to set
 */
void glint_tile_find(const glint_frame *frame, const glint_workspace *workspace, uint32_t tile, glint_tile *to);

#ifdef __cplusplus
}
#endif

#endif
