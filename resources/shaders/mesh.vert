// SPDX-License-Identifier: Apache-2.0
// A mesh with positions, normals and texture coordinates.
//   model_matrix      from the mesh to the scene
//   normal_matrix     its inverse transpose, for normals
//   view_projection   from the scene to the screen
layout(location = 0) in vec3 position;
layout(location = 1) in vec3 normal;
layout(location = 2) in vec2 texel;

uniform mat4 model_matrix;
uniform mat4 view_projection;
uniform mat3 normal_matrix;

out vec3 mesh_position;
out vec3 mesh_normal;
out vec2 mesh_texel;

void main() {
  vec4 place = model_matrix * vec4(position, 1.0);
  mesh_position = place.xyz;
  mesh_normal = normal_matrix * normal;
  mesh_texel = texel;
  gl_Position = view_projection * place;
}
