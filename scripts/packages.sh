# What the scripts that make packages share. Sourced behind scripts/common.sh.

packages=$repo/build/packages

# Files in packages have the time of the commit, so that the same sources give the same packages.
export SOURCE_DATE_EPOCH=${SOURCE_DATE_EPOCH:-$(git -C "$repo" log -1 --format=%ct)}

package_version() { # folder of a build
  sed -n 's/^CMAKE_PROJECT_VERSION:STATIC=//p' "$1/CMakeCache.txt"
}

# The build that packages for this processor come from. PLANISH_BUILD can name one that is there: it is
# configured further.
package_build=${PLANISH_BUILD:-$repo/build/package}

# Builds these targets.
build_for_package() { # folder of the build, flags of CMake, --, targets
  local folder=$1 flags=() && shift
  while [[ $1 != -- ]]; do flags+=("$1") && shift; done
  shift
  mkdir -p "$folder" "$packages"
  say "building ${folder#"$repo/"} (log: ${folder#"$repo/"}.log)"
  { cmake -S "$repo" -B "$folder" -G Ninja -DCMAKE_BUILD_TYPE=Release "${flags[@]}" &&
    cmake --build "$folder" --target "$@" -j "$(nproc)"; } >"$folder.log" 2>&1 ||
    { tail -n 40 "$folder.log" >&2 && return 1; }
}

install_component() { # folder of the build, component, prefix
  cmake --install "$1" --component "$2" --prefix "$3" >"$1.install.log" 2>&1 ||
    { cat "$1.install.log" >&2 && return 1; }
}

set_times() { # folder
  find "$1" -exec touch --no-dereference --date "@$SOURCE_DATE_EPOCH" {} +
}
