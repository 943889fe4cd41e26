# SPDX-License-Identifier: MIT
# `make meshes` writes examples/meshes/NAME.h from each MESH_NAME: a model or a generator, and options of the converter.

# The turntable's are without clusters: code that drops clusters would take more flash than its smallest board has left.
MESH_torus576 := torus:24x12 --name torus576 --licence MIT --no-clusters
MESH_teapot := examples/models/teapot.obj --licence MIT --no-clusters

MESH_sphere32x16 := sphere:32x16 --name sphere32x16 --licence MIT
MESH_sphere12x8 := sphere:12x8 --name sphere12x8 --licence MIT
MESH_cylinder30x2 := cylinder-capped:30x2:1,0.85 --name cylinder30x2 --licence MIT --no-clusters
MESH_cylinder_skewed := examples/models/cylinder-skewed.obj --name cylinder_skewed --licence MIT --no-clusters
MESH_plane1x1 := plane:1x1 --name plane1x1 --licence MIT
MESH_torus12x8 := torus:12x8 --name torus12x8 --licence MIT
MESH_torus48x24 := torus:48x24 --name torus48x24 --licence MIT
MESH_cylinder10x2 := cylinder-capped:10x2 --name cylinder10x2 --licence MIT
MESH_cylinder48x16 := cylinder-capped:48x16 --name cylinder48x16 --licence MIT
MESH_sphere10x6 := sphere:10x6 --name sphere10x6 --licence MIT
MESH_sphere48x32 := sphere:48x32 --name sphere48x32 --licence MIT

# Halloween's models were written by examples/scenes/make_models.py.
MESH_pumpkin_merry := examples/models/pumpkin-merry.obj --name pumpkin_merry --licence MIT
MESH_pumpkin_merry_lining := examples/models/pumpkin-merry-lining.obj --name pumpkin_merry_lining --licence MIT --double-sided
MESH_pumpkin_grim := examples/models/pumpkin-grim.obj --name pumpkin_grim --licence MIT
MESH_pumpkin_grim_lining := examples/models/pumpkin-grim-lining.obj --name pumpkin_grim_lining --licence MIT --double-sided
MESH_pumpkin := examples/models/pumpkin.obj --name pumpkin --licence MIT
MESH_stem := examples/models/stem.obj --name stem --licence MIT
MESH_tree := examples/models/tree.obj --name tree --licence MIT
MESH_tombstone := examples/models/tombstone.obj --name tombstone --licence MIT
MESH_picket := examples/models/picket.obj --name picket --licence MIT
MESH_bat_wing := examples/models/bat-wing.obj --name bat_wing --licence MIT --double-sided
MESH_flame := examples/models/flame.obj --name flame --licence MIT
MESH_glow := examples/models/glow.obj --name glow --licence MIT
MESH_stars := examples/models/stars.obj --name stars --licence MIT

MESH_cone24x1 := cone-capped:24x1 --name cone24x1 --licence MIT
MESH_cylinder24x1 := cylinder-capped:24x1 --name cylinder24x1 --licence MIT
MESH_box := box --name box --licence MIT
