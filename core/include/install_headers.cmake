# SPDX-License-Identifier: Apache-2.0
# Installs the headers as part of cmake --install. The includes are followed then, not when the build is
# configured, so that a change of a header does not configure the build again.
#   source        the checkout
#   headers       the headers for users: etak/f0.h;...
#   destination   the folder include/etak of the installation
cmake_policy(VERSION 3.24)  # an install script does not have the policies of the project
include(${source}/core/include/reached_headers.cmake)
reached_headers(reached ${source} ${headers})
foreach(header IN LISTS reached)
  string(REGEX REPLACE "^core/include/etak/" "" installed ${header})
  cmake_path(GET installed PARENT_PATH folder)
  file(INSTALL DESTINATION ${destination}/${folder} TYPE FILE FILES ${source}/${header})
endforeach()
