# Cross-builds for browsers with Debian's emscripten, on one thread: with threads its exceptions can only be caught
# by `catch (...)`. Libraries are looked for in build/wasm-root, which scripts/web makes.
include(/usr/share/emscripten/cmake/Modules/Platform/Emscripten.cmake)
list(APPEND CMAKE_FIND_ROOT_PATH "${CMAKE_CURRENT_LIST_DIR}/../build/wasm-root")
set(CMAKE_FIND_ROOT_PATH_MODE_INCLUDE ONLY)
set(CMAKE_FIND_ROOT_PATH_MODE_LIBRARY ONLY)
set(CMAKE_FIND_ROOT_PATH_MODE_PACKAGE ONLY)

string(JOIN " " planish_wasm_flags -fwasm-exceptions -msimd128)
set(CMAKE_C_FLAGS_INIT "${planish_wasm_flags}")
# What its libc++ 13 lacks comes before it.
set(CMAKE_CXX_FLAGS_INIT "${planish_wasm_flags} -isystem ${CMAKE_CURRENT_LIST_DIR}/../bindings/wasm/standard")
