# SPDX-License-Identifier: Apache-2.0
# cmake -DROOT=... -DOUT=... -DNAMES="brdf/a.glsl;..." -P embed_texts.cmake Writes a C++ source that holds the
# named texts (below core; shaders/* below resources) as raw string literals, in this order.
set(rows "")
foreach(name IN LISTS NAMES)
  if(name MATCHES "^shaders/")
    file(READ ${ROOT}/resources/${name} text)
  else()
    file(READ ${ROOT}/core/${name} text)
  endif()
  string(APPEND rows "    {\"${name}\", R\"glsl(${text})glsl\"},\n")
endforeach()
file(WRITE ${OUT} "// SPDX-License-Identifier: Apache-2.0
// Written by core/glsl/embed_texts.cmake.
#include \"core/glsl/glsl_source.h\"

namespace etak {

std::span<const GlslFile> glsl_files() {
  static constexpr GlslFile files[] = {
${rows}  };
  return files;
}

}  // namespace etak
")
