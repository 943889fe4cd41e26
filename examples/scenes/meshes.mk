# SPDX-License-Identifier: MIT
# The meshes of the scenes: `make meshes` writes each anew from its source, with the options of the converter.

SCENE_MESHES += examples/meshes/sphere32x16.h
SCENE_MESH_sphere32x16 := sphere:32x16 --name sphere32x16 --licence MIT

SCENE_MESHES += examples/meshes/sphere12x8.h
SCENE_MESH_sphere12x8 := sphere:12x8 --name sphere12x8 --licence MIT

SCENE_MESHES += examples/meshes/cylinder30x2.h
SCENE_MESH_cylinder30x2 := cylinder-capped:30x2 --name cylinder30x2 --licence MIT

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
