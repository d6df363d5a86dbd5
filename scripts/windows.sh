# What the Windows program is built and tried with, on Debian. Sourced behind scripts/common.sh and
# scripts/debian_sources.sh.

windows_packages="
clang-14                   command clang++-14
lld-14                     command ld.lld-14
g++-mingw-w64-x86-64-posix command x86_64-w64-mingw32-g++-posix
libz-mingw-w64-dev         header zlib.h
dpkg-dev                   command dpkg-source
googletest                 header gtest/gtest.h
librapidcheck-dev          header rapidcheck.h
"
wine_packages="
wine                command wine
wine64              command wine
xvfb                command xvfb-run
xauth               command xauth
"
installer_packages="
nsis                command makensis
zip                 command zip
"

windows_root=$repo/build/windows-root
windows_program=$repo/build/windows/apps/planish/planish.exe
mingw=x86_64-w64-mingw32

# Builds with CMake into build/windows-root what comes with it.
install_for_windows() { # name, folder of sources, flags of cmake
  local name=$1 from=$2 build=$windows_root/sources/$1-build && shift 2
  { cmake -S "$from" -B "$build" -G Ninja -DCMAKE_BUILD_TYPE=Release "-DCMAKE_INSTALL_PREFIX=$windows_root" \
    "-DCMAKE_TOOLCHAIN_FILE=$repo/cmake/windows-x86_64.cmake" "-DCMAKE_CXX_FLAGS_RELEASE=-O2 -w" "$@" &&
    cmake --build "$build" --target install -j "$(nproc)"; } >"$build.log" 2>&1 ||
    { tail -n 40 "$build.log" >&2 && say "could not build $name for Windows" && return 1; }
}

# Only zlib is there for mingw. What is headers alone comes as links: all of /usr/include must not be
# seen, as it is this system's.
link_headers_for_windows() {
  local name
  for name in include/{eigen3,fast_float,nlohmann}; do
    mkdir -p "$windows_root/include"
    ln -sfn "/usr/$name" "$windows_root/$name"
  done
  for name in share/cmake/nlohmann_json lib/cmake/FastFloat share/eigen3/cmake; do
    mkdir -p "$windows_root/$name"
    cp "/usr/$name"/*.cmake "$windows_root/$name"
  done
}

# Makes build/windows-root. Of libpng this needs its C sources alone.
prepare_windows_libraries() {
  local folder
  [[ ! -f $windows_root/complete ]] || return 0
  say "building libraries for Windows in build/windows-root"
  mkdir -p "$windows_root/sources"
  link_headers_for_windows || return 1
  make_clipper "$windows_root" $mingw-ar $mingw-g++-posix || return 1
  folder=$(unpack_source libpng1.6 "$windows_root/sources/libpng") || return 1
  install_for_windows libpng "$folder" -DPNG_SHARED=OFF -DPNG_TESTS=OFF \
    -DCMAKE_C_COMPILER=$mingw-gcc-posix || return 1
  install_for_windows googletest /usr/src/googletest -DCMAKE_C_COMPILER=$mingw-gcc-posix || return 1
  if folder=$(unpack_source rapidcheck "$windows_root/sources/rapidcheck"); then
    install_for_windows rapidcheck "$folder" || return 1
  else
    say "no property tests for Windows without the sources of rapidcheck"
  fi
  touch "$windows_root/complete"
}
