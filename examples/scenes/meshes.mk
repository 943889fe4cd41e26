# SPDX-License-Identifier: MIT
# The meshes of the scenes: `make meshes` writes each anew from its source, with the options of the converter.

SCENE_MESHES += examples/meshes/sphere32x16.h
SCENE_MESH_sphere32x16 := sphere:32x16 --name sphere32x16 --licence MIT
