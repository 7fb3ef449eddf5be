# SPDX-License-Identifier: Apache-2.0
# Installs the build in BUILD into PREFIX, after removing what an earlier run has installed there.
file(REMOVE_RECURSE ${PREFIX})
execute_process(COMMAND ${CMAKE_COMMAND} --install ${BUILD} --prefix ${PREFIX} COMMAND_ERROR_IS_FATAL ANY)
