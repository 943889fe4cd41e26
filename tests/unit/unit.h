/* SPDX-License-Identifier: MIT */
/* The unit suite's cases, one list, and their declarations. */
#ifndef GLINT_UNIT_H
#define GLINT_UNIT_H

#define UNIT_CASES(CASE)                            \
    CASE(same_bits_on_every_core)                   \
    CASE(same_bits_for_every_tile_and_arena)        \
    CASE(checksums_do_not_tell_byte_orders)         \
    CASE(init_refuses_bad_configurations)           \
    CASE(null_pointers_are_refused)                 \
    CASE(null_pointers_in_scenes_are_refused)       \
    CASE(failed_init_leaves_zeros)                  \
    CASE(failed_begin_leaves_zeros)                 \
    CASE(failed_questions_leave_answers)            \
    CASE(bad_cameras_are_refused)                   \
    CASE(bad_lights_are_refused)                    \
    CASE(bad_colours_are_refused)                   \
    CASE(unknown_flags_are_refused)                 \
    CASE(bad_meshes_are_refused)                    \
    CASE(bad_clusters_are_refused)                  \
    CASE(bad_layouts_are_refused)                   \
    CASE(layouts_draw_what_arrays_do)               \
    CASE(clusters_that_face_away_are_dropped)       \
    CASE(bad_poses_are_refused)                     \
    CASE(limits_are_accepted)                       \
    CASE(arena_one_byte_short_is_refused)           \
    CASE(frames_refuse_small_arenas)                \
    CASE(flush_without_wait)                        \
    CASE(status_sentences)                          \
    CASE(statistics)                                \
    CASE(arena_used_is_what_was_written)            \
    CASE(row_bytes)                                 \
    CASE(paint_is_diffuse_and_its_fraction_ambient) \
    CASE(light_at_no_distance_adds_nothing)         \
    CASE(torus_far_around_the_eye_is_drawn)         \
    CASE(farthest_surfaces_are_lit)                 \
    CASE(farthest_row_is_drawn)                     \
    CASE(offset_of_one_step_moves_a_mesh)           \
    CASE(normals_that_differ_in_x_shade_a_triangle) \
    CASE(corners_below_a_power_of_two_stay)         \
    CASE(light_at_the_only_pixel_is_left_out)       \
    CASE(far_squares_without_depth)                 \
    CASE(longest_normals_are_made_unit)             \
    CASE(mirrored_light_is_at_full_strength)        \
    CASE(bad_lamps_are_refused)                     \
    CASE(generators_fill_their_room)                \
    CASE(generators_face_outwards)                  \
    CASE(generators_follow_their_formulas)          \
    CASE(generators_refuse_bad_input)

#define UNIT_DECLARE(name) void name(void);
UNIT_CASES(UNIT_DECLARE)
#undef UNIT_DECLARE

#endif
