# SPDX-License-Identifier: MIT
# The meshes of the scenes: `make meshes` writes each anew from its source, with the options of the converter.

SCENE_MESHES += examples/meshes/sphere32x16.h
SCENE_MESH_sphere32x16 := sphere:32x16 --name sphere32x16 --licence MIT

SCENE_MESHES += examples/meshes/sphere12x8.h
SCENE_MESH_sphere12x8 := sphere:12x8 --name sphere12x8 --licence MIT

SCENE_MESHES += examples/meshes/cylinder30x2.h
SCENE_MESH_cylinder30x2 := cylinder-capped:30x2:1,0.85 --name cylinder30x2 --licence MIT --no-clusters

SCENE_MESHES += examples/meshes/cylinder_skewed.h
SCENE_MESH_cylinder_skewed := examples/models/cylinder-skewed.obj --name cylinder_skewed --licence MIT --no-clusters

SCENE_MESHES += examples/meshes/plane1x1.h
SCENE_MESH_plane1x1 := plane:1x1 --name plane1x1 --licence MIT

SCENE_MESHES += examples/meshes/torus12x8.h
SCENE_MESH_torus12x8 := torus:12x8 --name torus12x8 --licence MIT

SCENE_MESHES += examples/meshes/torus48x24.h
SCENE_MESH_torus48x24 := torus:48x24 --name torus48x24 --licence MIT

SCENE_MESHES += examples/meshes/cylinder10x2.h
SCENE_MESH_cylinder10x2 := cylinder-capped:10x2 --name cylinder10x2 --licence MIT

SCENE_MESHES += examples/meshes/cylinder48x16.h
SCENE_MESH_cylinder48x16 := cylinder-capped:48x16 --name cylinder48x16 --licence MIT

SCENE_MESHES += examples/meshes/sphere10x6.h
SCENE_MESH_sphere10x6 := sphere:10x6 --name sphere10x6 --licence MIT

SCENE_MESHES += examples/meshes/sphere48x32.h
SCENE_MESH_sphere48x32 := sphere:48x32 --name sphere48x32 --licence MIT

# Halloween; examples/scenes/make_models.py wrote these models.

SCENE_MESHES += examples/meshes/pumpkin_merry.h
SCENE_MESH_pumpkin_merry := examples/models/pumpkin-merry.obj --name pumpkin_merry --licence MIT

SCENE_MESHES += examples/meshes/pumpkin_merry_lining.h
SCENE_MESH_pumpkin_merry_lining := examples/models/pumpkin-merry-lining.obj --name pumpkin_merry_lining --licence MIT --double-sided

SCENE_MESHES += examples/meshes/pumpkin_grim.h
SCENE_MESH_pumpkin_grim := examples/models/pumpkin-grim.obj --name pumpkin_grim --licence MIT

SCENE_MESHES += examples/meshes/pumpkin_grim_lining.h
SCENE_MESH_pumpkin_grim_lining := examples/models/pumpkin-grim-lining.obj --name pumpkin_grim_lining --licence MIT --double-sided

SCENE_MESHES += examples/meshes/pumpkin.h
SCENE_MESH_pumpkin := examples/models/pumpkin.obj --name pumpkin --licence MIT

SCENE_MESHES += examples/meshes/stem.h
SCENE_MESH_stem := examples/models/stem.obj --name stem --licence MIT

SCENE_MESHES += examples/meshes/tree.h
SCENE_MESH_tree := examples/models/tree.obj --name tree --licence MIT

SCENE_MESHES += examples/meshes/tombstone.h
SCENE_MESH_tombstone := examples/models/tombstone.obj --name tombstone --licence MIT

SCENE_MESHES += examples/meshes/picket.h
SCENE_MESH_picket := examples/models/picket.obj --name picket --licence MIT

SCENE_MESHES += examples/meshes/bat_wing.h
SCENE_MESH_bat_wing := examples/models/bat-wing.obj --name bat_wing --licence MIT --double-sided

SCENE_MESHES += examples/meshes/flame.h
SCENE_MESH_flame := examples/models/flame.obj --name flame --licence MIT

SCENE_MESHES += examples/meshes/glow.h
SCENE_MESH_glow := examples/models/glow.obj --name glow --licence MIT

SCENE_MESHES += examples/meshes/stars.h
SCENE_MESH_stars := examples/models/stars.obj --name stars --licence MIT

SCENE_MESHES += examples/meshes/cone24x1.h
SCENE_MESH_cone24x1 := cone-capped:24x1 --name cone24x1 --licence MIT

SCENE_MESHES += examples/meshes/cylinder24x1.h
SCENE_MESH_cylinder24x1 := cylinder-capped:24x1 --name cylinder24x1 --licence MIT

SCENE_MESHES += examples/meshes/box.h
SCENE_MESH_box := box --name box --licence MIT
