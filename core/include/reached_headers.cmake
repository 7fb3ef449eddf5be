# SPDX-License-Identifier: Apache-2.0
# reached_headers(VARIABLE SOURCE HEADERS...): the headers for users (etak/f0.h ...) and those of core that they include,
# directly or through others, as paths below the checkout SOURCE.
function(reached_headers variable source)
  set(open ${ARGN})
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
  set(${variable} ${reached} PARENT_SCOPE)
endfunction()
