# SPDX-License-Identifier: Apache-2.0
# WebAssembly by Debian's clang, libc++ and wasi-libc, without a system: nothing of WASI is asked for. The compiler comes from
# bookworm-security, where another version may take its place: ETAK_CLANG names it.
set(ETAK_CLANG 22 CACHE STRING "Version of the Debian packages of clang for WebAssembly")
set(CMAKE_TRY_COMPILE_PLATFORM_VARIABLES ETAK_CLANG)
set(CMAKE_SYSTEM_NAME Generic)
set(CMAKE_SYSTEM_PROCESSOR wasm32)
set(CMAKE_CXX_COMPILER clang++-${ETAK_CLANG})
set(CMAKE_CXX_COMPILER_TARGET wasm32-wasi)
set(CMAKE_AR llvm-ar-${ETAK_CLANG} CACHE FILEPATH "")
set(CMAKE_RANLIB llvm-ranlib-${ETAK_CLANG} CACHE FILEPATH "")
set(CMAKE_TRY_COMPILE_TARGET_TYPE STATIC_LIBRARY)
set(CMAKE_CXX_FLAGS_INIT "-Wno-deprecated -fwasm-exceptions -msimd128 -include ${CMAKE_CURRENT_LIST_DIR}/threads.h")
# A module without main(), whose functions are called from outside. Stacks come first in memory, so that one that is too deep
# ends the run in place of writing over data.
set(CMAKE_EXE_LINKER_FLAGS_INIT "-mexec-model=reactor -Wl,--stack-first,-z,stack-size=2097152,--strip-all,--wrap=strtold")
set(CMAKE_EXECUTABLE_SUFFIX_CXX .wasm)
set(ETAK_WEB ON)
set(ETAK_WEB_LIBRARY ${CMAKE_CURRENT_LIST_DIR}/library)  # headers that libc++ lacks
