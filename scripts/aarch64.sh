# Cross-building the static program for 64-bit ARM on Debian 12, in build/same_bits/aarch64: with clang, which
# takes two thirds of the time of GCC, and the libraries of GCC's cross compiler.
# Sourced behind scripts/debian_sources.sh.

aarch64_packages="
clang-14                 command clang++-14
g++-aarch64-linux-gnu    command aarch64-linux-gnu-g++
qemu-user                command qemu-aarch64
dpkg-dev                 command dpkg-source
"
aarch64_build=$repo/build/same_bits/aarch64

# What the program links with, as static libraries: of Debian's packages, and Clipper.
prepare_aarch64_libraries() {
  local package root=$aarch64_build-root
  make_clipper "$aarch64_build-clipper" aarch64-linux-gnu-ar aarch64-linux-gnu-g++ || return 1
  [[ ! -f $root/ready ]] || return 0
  mkdir -p "$root/packages"
  (cd "$root/packages" && own_apt download libpng-dev:arm64 libpng16-16:arm64 zlib1g:arm64 zlib1g-dev:arm64) \
    >"$root/download.log" 2>&1 || { cat "$root/download.log" >&2 && return 1; }
  for package in "$root"/packages/*.deb; do
    dpkg -x "$package" "$root" || return 1
  done
  touch "$root/ready"
}

# Flags of CMake, a line each.
aarch64_flags() {
  local include=$aarch64_build-root/usr/include libraries=$aarch64_build-root/usr/lib/aarch64-linux-gnu
  printf '%s\n' -DCMAKE_SYSTEM_NAME=Linux -DCMAKE_SYSTEM_PROCESSOR=aarch64 \
    -DCMAKE_CXX_COMPILER=clang++-14 -DCMAKE_CXX_COMPILER_TARGET=aarch64-linux-gnu \
    -DCMAKE_EXE_LINKER_FLAGS=-static \
    -DCMAKE_CROSSCOMPILING_EMULATOR=qemu-aarch64 -DPLANISH_PRECOMPILE_HEADERS=ON \
    -DPNG_LIBRARY="$libraries/libpng16.a" -DPNG_PNG_INCLUDE_DIR="$include" \
    -DZLIB_LIBRARY="$libraries/libz.a" -DZLIB_INCLUDE_DIR="$include" \
    -DPolyclipping_LIBRARY="$aarch64_build-clipper/lib/libpolyclipping.a" \
    -DPolyclipping_INCLUDE_DIR="$aarch64_build-clipper/include"
}
