# SPDX-License-Identifier: Apache-2.0
# Installs the headers as part of cmake --install. The includes are followed then, not when the build is
# configured, so that a change of a header does not configure the build again.
#   source        the checkout
#   headers       the headers for users: etak/f0.h;...
#   destination   the folder include/etak of the installation
cmake_policy(VERSION 3.24)  # an install script does not have the policies of the project
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
