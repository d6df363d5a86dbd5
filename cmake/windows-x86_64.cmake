# Cross-builds for 64-bit Windows with Debian's clang, which takes half the time of GCC, and the C++ library
# of its mingw-w64: packages clang-14, lld-14, g++-mingw-w64-x86-64-posix and libz-mingw-w64-dev. Libraries
# that Debian has not for Windows are looked for in build/windows-root, which scripts/package_windows makes.
set(CMAKE_SYSTEM_NAME Windows)
set(CMAKE_SYSTEM_PROCESSOR x86_64)
set(CMAKE_CXX_COMPILER clang++-14)
set(CMAKE_CXX_COMPILER_TARGET x86_64-w64-mingw32)
set(CMAKE_RC_COMPILER x86_64-w64-mingw32-windres)

# Nothing of /usr/include and /usr/lib is seen: it is of this system.
set(CMAKE_FIND_ROOT_PATH "${CMAKE_CURRENT_LIST_DIR}/../build/windows-root" /usr/x86_64-w64-mingw32)
set(CMAKE_FIND_ROOT_PATH_MODE_PROGRAM NEVER)
set(CMAKE_FIND_ROOT_PATH_MODE_INCLUDE ONLY)
set(CMAKE_FIND_ROOT_PATH_MODE_LIBRARY ONLY)
set(CMAKE_FIND_ROOT_PATH_MODE_PACKAGE ONLY)

# The C++ library with POSIX threads. Its GCC keeps thread_local variables in a way of its own, and compares
# type_info in no inline function; both have to be the same here. The linker stands among the flags of C++ since
# libpng is made by GCC, which knows it by no such name.
file(GLOB gcc /usr/lib/gcc/x86_64-w64-mingw32/*-posix)
string(JOIN " " CMAKE_CXX_FLAGS_INIT -nostdinc++ -isystem ${gcc}/include/c++ -isystem
       ${gcc}/include/c++/x86_64-w64-mingw32 -femulated-tls -D__GXX_TYPEINFO_EQUALITY_INLINE=0
       -fuse-ld=lld-14 -B${gcc} -L${gcc} -Wno-unused-command-line-argument)
set(CMAKE_CXX_STANDARD_LIBRARIES "-lstdc++ -lpthread -ladvapi32 -lole32 -lshell32"
    CACHE STRING "Linked into every program")

# The program needs no DLL but the system's.
set(ZLIB_LIBRARY /usr/x86_64-w64-mingw32/lib/libz.a CACHE FILEPATH "Static zlib")
set(CMAKE_EXE_LINKER_FLAGS_INIT -static)
