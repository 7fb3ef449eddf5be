# SPDX-License-Identifier: Apache-2.0
# Makes the reference of the headers for users as HTML, by doxygen. A warning of doxygen ends it.
#   SOURCE    the checkout
#   HEADERS   the headers for users, with spaces between
#   OUTPUT    the folder that the folder html is made in
#   VERSION, DOXYGEN, PYTHON
cmake_policy(VERSION 3.24)
include(${SOURCE}/core/include/reached_headers.cmake)
string(REPLACE " " ";" headers "${HEADERS}")
reached_headers(inputs ${SOURCE} ${headers})
set(source ${SOURCE})
set(version ${VERSION})
set(output ${OUTPUT})
file(REMOVE_RECURSE ${OUTPUT}/html ${OUTPUT}/headers)
# One process for all headers: as a filter of doxygen it would be started for each of them several times.
execute_process(COMMAND ${PYTHON} ${SOURCE}/core/include/reference_filter.py ${SOURCE} ${OUTPUT}/headers ${inputs}
  COMMAND_ERROR_IS_FATAL ANY)
list(TRANSFORM inputs REPLACE "^.+$" "\"${OUTPUT}/headers/\\0\"")
list(JOIN inputs " " inputs)
configure_file(${SOURCE}/core/include/Doxyfile.in ${OUTPUT}/Doxyfile @ONLY)
execute_process(COMMAND ${DOXYGEN} ${OUTPUT}/Doxyfile COMMAND_ERROR_IS_FATAL ANY)

# Members may say by their names all there is to say, types may not: a second reading, which writes nothing, lists what
# has no comment.
file(READ ${OUTPUT}/Doxyfile doxyfile)
file(WRITE ${OUTPUT}/Doxyfile.bare "${doxyfile}
EXTRACT_ALL = NO
GENERATE_HTML = NO
WARN_AS_ERROR = NO
")
execute_process(COMMAND ${DOXYGEN} ${OUTPUT}/Doxyfile.bare ERROR_VARIABLE bare COMMAND_ERROR_IS_FATAL ANY)
string(REGEX MATCHALL "[^\n]*(Compound [^\n]*|\\((enumeration|typedef)\\)[^\n]*) is not documented" bare "${bare}")
if(bare)
  list(JOIN bare "\n" bare)
  message(FATAL_ERROR "types without a comment:\n${bare}")
endif()
