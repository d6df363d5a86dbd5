# What the scripts that make packages share. Sourced behind scripts/common.sh.

packages=$repo/build/packages

# Files in packages have the time of the commit, so that the same sources give the same packages.
export SOURCE_DATE_EPOCH=${SOURCE_DATE_EPOCH:-$(git -C "$repo" log -1 --format=%ct)}

package_version() { # folder of a build
  sed -n 's/^CMAKE_PROJECT_VERSION:STATIC=//p' "$1/CMakeCache.txt"
}

# Builds the program with its manual pages and completions.
build_for_package() { # folder of the build, flags of CMake
  local folder=$1 log=$1.log
  mkdir -p "$folder" "$packages"
  say "building ${folder#"$repo/"} (log: ${log#"$repo/"})"
  { cmake -S "$repo" -B "$folder" -G Ninja -DCMAKE_BUILD_TYPE=Release "${@:2}" &&
    cmake --build "$folder" --target planish_app planish_manual -j "$(nproc)"; } >"$log" 2>&1 ||
    { tail -n 40 "$log" >&2 && return 1; }
}

install_component() { # folder of the build, component, flags of cmake --install
  cmake --install "$1" --component "$2" "${@:3}" >"$1.install.log" 2>&1 ||
    { cat "$1.install.log" >&2 && return 1; }
}

set_times() { # folder
  find "$1" -exec touch --no-dereference --date "@$SOURCE_DATE_EPOCH" {} +
}
