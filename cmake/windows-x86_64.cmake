# Cross-builds for 64-bit Windows with Debian's mingw-w64: packages g++-mingw-w64-x86-64-posix and
# libz-mingw-w64-dev. Libraries that Debian has not for Windows are looked for in build/windows-root,
# which scripts/package_windows makes.
set(CMAKE_SYSTEM_NAME Windows)
set(CMAKE_SYSTEM_PROCESSOR x86_64)
set(CMAKE_CXX_COMPILER x86_64-w64-mingw32-g++-posix)
set(CMAKE_RC_COMPILER x86_64-w64-mingw32-windres)

# Nothing of /usr/include and /usr/lib is seen: it is of this system.
set(CMAKE_FIND_ROOT_PATH "${CMAKE_CURRENT_LIST_DIR}/../build/windows-root" /usr/x86_64-w64-mingw32)
set(CMAKE_FIND_ROOT_PATH_MODE_PROGRAM NEVER)
set(CMAKE_FIND_ROOT_PATH_MODE_INCLUDE ONLY)
set(CMAKE_FIND_ROOT_PATH_MODE_LIBRARY ONLY)
set(CMAKE_FIND_ROOT_PATH_MODE_PACKAGE ONLY)

# The program needs no DLL but the system's.
set(ZLIB_LIBRARY /usr/x86_64-w64-mingw32/lib/libz.a CACHE FILEPATH "Static zlib")
set(CMAKE_EXE_LINKER_FLAGS_INIT -static)
# GCC aligns variables on the stack to 16 bytes only, whatever their type asks for (its bug 54412).
set(CMAKE_CXX_FLAGS_INIT -Wa,-muse-unaligned-vector-move)
