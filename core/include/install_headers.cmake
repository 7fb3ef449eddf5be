# SPDX-License-Identifier: Apache-2.0
# Part of cmake --install. Includes are followed when headers are installed, not when the build is configured, so that no
# change of a header configures the build again.
#   source        the checkout
#   headers       those for users: etak/f0.h;...
#   destination   the folder include/etak of the installation
cmake_policy(VERSION 3.24)  # an install script has no policies of its project
set(open ${headers})
list(TRANSFORM open PREPEND core/include/)
set(reached)
while(open)
  list(POP_FRONT open header)
  if(header IN_LIST reached)
    continue()
  endif()
  list(APPEND reached ${header})
  file(STRINGS ${source}/${header} includes REGEX "^#include \"core/.*\"$")
  list(TRANSFORM includes REPLACE "^#include \"(.*)\"$" "\\1")
  list(APPEND open ${includes})
endwhile()
foreach(header IN LISTS reached)
  string(REGEX REPLACE "^core/include/etak/" "" installed ${header})
  cmake_path(GET installed PARENT_PATH folder)
  file(INSTALL DESTINATION ${destination}/${folder} TYPE FILE FILES ${source}/${header})
endforeach()
