# SPDX-License-Identifier: Apache-2.0
# The Debian packages, which ./dev packages builds (resources/doc/install.md): one for each component that is installed.
#   etak          program       the program, libetak-pictures.so, manual pages, completions, schemas
#   etak-editor   editor        the editor, libetak-editor-pictures.so and its files for the desktop
#   libetak-dev   development   libraries, headers, files for CMake and pkg-config, the reference
#   python3-etak  python        the Python module, where it is built
# stage.cmake adds what only a package holds: copyright, changelog, compressed manual pages.
get_cmake_property(installed COMPONENTS)
set(CPACK_COMPONENTS_ALL program editor development python)
foreach(component program editor development python)
  if(NOT component IN_LIST installed)
    list(REMOVE_ITEM CPACK_COMPONENTS_ALL ${component})  # not built
  endif()
endforeach()

set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_CONTACT "etak developers <etak@example.org>" CACHE STRING "Maintainer that the packages name")
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "")  # each package has a summary of its own, the first line of its description
set(CPACK_STRIP_FILES ON)
set(CPACK_INSTALL_DEFAULT_DIRECTORY_PERMISSIONS
  OWNER_READ OWNER_WRITE OWNER_EXECUTE GROUP_READ GROUP_EXECUTE WORLD_READ WORLD_EXECUTE)
set(CPACK_PRE_BUILD_SCRIPTS ${PROJECT_SOURCE_DIR}/resources/packages/stage.cmake)
set(CPACK_ETAK_SOURCE ${PROJECT_SOURCE_DIR})
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_RELEASE 1)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_COMPRESSION_TYPE xz)

set(CPACK_DEBIAN_PROGRAM_PACKAGE_NAME etak)
set(CPACK_DEBIAN_PROGRAM_PACKAGE_SECTION graphics)
set(CPACK_DEBIAN_PROGRAM_PACKAGE_RECOMMENDS "fonts-dejavu-core")  # the text of plots as PNG
set(CPACK_DEBIAN_PROGRAM_PACKAGE_SUGGESTS "etak-editor, libgl1-mesa-dri")
set(CPACK_DEBIAN_PROGRAM_DESCRIPTION "measured optics into materials a renderer can trust
etak computes the colour of a surface at normal incidence (F0) from published
measurements of n and k, says what every shortcut of shading costs in colour
and saves in time, packs materials into texture atlases, and finds what
cannot be real in textures, scenes and data.
.
This package has the program, its library of cited materials, manual pages
and completions of shells.")

set(CPACK_DEBIAN_EDITOR_PACKAGE_NAME etak-editor)
set(CPACK_DEBIAN_EDITOR_PACKAGE_SECTION graphics)
set(CPACK_DEBIAN_EDITOR_PACKAGE_RECOMMENDS "libgl1-mesa-dri, shared-mime-info")
set(CPACK_DEBIAN_EDITOR_PACKAGE_SUGGESTS "etak, qt6-wayland")
set(CPACK_DEBIAN_EDITOR_DESCRIPTION "editor of materials from measured optics
Shows the measured materials of etak on a sphere under the light models of
the literature, with the curves that their colour comes from. Materials are
edited, checked while they are edited, packed into texture atlases and
exported to MaterialX, glTF and the values of other programs.")

set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_NAME libetak-dev)
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_SECTION libdevel)
# What the static libraries need to be linked.
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_DEPENDS "libxxhash-dev, zlib1g-dev, libzstd-dev, libisal-dev, libpugixml-dev")
if(ETAK_BUILD_PICTURES)
  string(APPEND CPACK_DEBIAN_DEVELOPMENT_PACKAGE_DEPENDS
    ", libbenchmark-dev, libepoxy-dev, libopencolorio-dev, libopenimageio-dev, libmeshoptimizer-dev, libdraco-dev, libwebp-dev, libastcenc-dev")
endif()
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_SUGGESTS "cmake, pkg-config")
set(CPACK_DEBIAN_DEVELOPMENT_DESCRIPTION "C++ library of measured optics and shading models
Static libraries and headers of etak: spectra of n and k to F0 and its
colour, a library of cited materials, Fresnel terms and BRDFs in C++ and
GLSL, packing of texture pairs, and checks of textures and scenes.
.
Files for CMake and pkg-config are there, and the reference as HTML.")

set(CPACK_DEBIAN_PYTHON_PACKAGE_NAME python3-etak)
set(CPACK_DEBIAN_PYTHON_PACKAGE_SECTION python)
set(CPACK_DEBIAN_PYTHON_PACKAGE_CONTROL_EXTRA
  "${PROJECT_SOURCE_DIR}/resources/packages/python/postinst;${PROJECT_SOURCE_DIR}/resources/packages/python/prerm")
set(CPACK_DEBIAN_PYTHON_PACKAGE_CONTROL_STRICT_PERMISSION ON)
set(CPACK_DEBIAN_PYTHON_PACKAGE_RECOMMENDS "fonts-dejavu-core")
set(CPACK_DEBIAN_PYTHON_PACKAGE_SUGGESTS "python3-matplotlib")
set(CPACK_DEBIAN_PYTHON_DESCRIPTION "Python module of measured optics and shading models
The library of etak for Python, with numpy arrays: F0 of measured materials
and of own spectra, Fresnel terms, the material library, packing of texture
pairs, and checks of textures and scenes.")
if(python IN_LIST CPACK_COMPONENTS_ALL AND EXISTS /usr/bin/python3)
  # The module is for one version of Python, Debian's own.
  execute_process(COMMAND /usr/bin/python3 -c "import sys; print(sys.version_info.minor)" OUTPUT_VARIABLE minor
    OUTPUT_STRIP_TRAILING_WHITESPACE COMMAND_ERROR_IS_FATAL ANY)
  math(EXPR next "${minor} + 1")
  set(CPACK_DEBIAN_PYTHON_PACKAGE_DEPENDS "python3 (>= 3.${minor}~), python3 (<< 3.${next}~), python3-numpy")
endif()
include(CPack)
