# What the program is built with for browsers, on Debian. Sourced behind scripts/common.sh and
# scripts/debian_sources.sh.

# Debian's emscripten does not know where Debian's Node packages are.
export NODE_PATH=/usr/share/nodejs

wasm_root=$repo/build/wasm-root

# Builds with CMake into build/wasm-root what comes with it.
install_for_wasm() { # name, folder of sources, flags of cmake
  local name=$1 from=$2 build=$wasm_root/sources/$1-build && shift 2
  { cmake -S "$from" -B "$build" -G Ninja -DCMAKE_BUILD_TYPE=Release "-DCMAKE_INSTALL_PREFIX=$wasm_root" \
    "-DCMAKE_TOOLCHAIN_FILE=$repo/cmake/wasm.cmake" "-DCMAKE_C_FLAGS_RELEASE=-O2 -w" \
    -DBUILD_SHARED_LIBS=OFF "$@" &&
    cmake --build "$build" --target install -j "$(nproc)"; } >"$build.log" 2>&1 ||
    { tail -n 40 "$build.log" >&2 && say "could not build $name for browsers" && return 1; }
}

# What is headers alone comes as links: all of /usr/include must not be seen, as it is this system's.
link_headers_for_wasm() {
  local name
  mkdir -p "$wasm_root/include"
  for name in include/{eigen3,fast_float,nlohmann}; do
    ln -sfn "/usr/$name" "$wasm_root/$name"
  done
  for name in share/cmake/nlohmann_json lib/cmake/FastFloat share/eigen3/cmake; do
    mkdir -p "$wasm_root/$name"
    cp "/usr/$name"/*.cmake "$wasm_root/$name"
  done
}

# By hand: what CMake builds it with is not whole in Debian's sources.
make_wasm_zlib() {
  local folder source objects=()
  folder=$(unpack_source zlib "$wasm_root/sources/zlib") || return 1
  cp "$folder"/{zlib,zconf}.h "$wasm_root/include"
  for source in adler32 compress crc32 deflate infback inffast inflate inftrees trees uncompr zutil; do
    objects+=("$wasm_root/sources/$source.o")
    emcc -O2 -fwasm-exceptions -w -c "$folder/$source.c" -o "${objects[-1]}" || return 1
  done
  emar rcs "$wasm_root/lib/libz.a" "${objects[@]}"
}

# Makes build/wasm-root.
prepare_wasm_libraries() {
  local folder
  [[ ! -f $wasm_root/complete ]] || return 0
  say "building libraries for browsers in build/wasm-root"
  mkdir -p "$wasm_root/sources"
  link_headers_for_wasm || return 1
  make_clipper "$wasm_root" emar em++ -fwasm-exceptions || return 1
  make_wasm_zlib || return 1
  folder=$(unpack_source libpng1.6 "$wasm_root/sources/libpng") || return 1
  install_for_wasm libpng "$folder" -DPNG_SHARED=OFF -DPNG_TESTS=OFF -DPNG_EXECUTABLES=OFF || return 1
  touch "$wasm_root/complete"
}
