# Shared by scripts/run, scripts/test, bench/ and .ci/run: which packages are needed, installing, building.
# All that is said here goes to standard error; standard output belongs to the job.

# Debian package, and how to tell on other systems that what it holds is there. A "program" may be
# of any package also on Debian: those of Node's makers hold npm too and do not go with Debian's.
build_packages="
g++                 command g++
cmake               command cmake
ninja-build         command ninja
libeigen3-dev       header eigen3/Eigen/Core
libfast-float-dev   header fast_float/fast_float.h
libpng-dev          header png.h
libpolyclipping-dev header polyclipping/clipper.hpp
nlohmann-json3-dev  header nlohmann/json.hpp
"
# For the 3D view of the report pages: without them pages have still pictures.
page_packages="
nodejs              program node
npm                 program npm
"
test_packages="
chromium            command chromium
clang-format-14     command clang-format-14
libgmock-dev        header gmock/gmock.h
libgtest-dev        header gtest/gtest.h
libmpfr-dev         header mpfr.h
librapidcheck-dev   header rapidcheck.h
librsvg2-bin        command rsvg-convert
poppler-utils       command pdftoppm
python3             command python3
python3-ezdxf       python ezdxf
python3-meshio      python meshio
qpdf                command qpdf
valgrind            command valgrind
"
check_packages="
clang-14            command clang++-14
clang-tidy-14       command clang-tidy-14
doxygen             command doxygen
libclang-rt-14-dev  header sanitizer/asan_interface.h
llvm-14             command llvm-symbolizer-14
"
bench_packages="
libbenchmark-dev    header benchmark/benchmark.h
"
# For the Python package, and for checking it and its notebooks.
python_packages="
pybind11-dev        header pybind11/pybind11.h
python3-dev         command python3-config
python3-numpy       python numpy
python3-pip         python pip
python3-setuptools  python setuptools
python3-wheel       python wheel
"
notebook_packages="
mypy                command mypy
python3-ipykernel   python ipykernel
python3-matplotlib  python matplotlib
python3-nbclient    python nbclient
python3-venv        python ensurepip
"
# For the program in the browser.
web_packages="
emscripten          command em++
dpkg-dev            command dpkg-source
xz-utils            command xz
"

paper_packages="
python3             command python3
python3-numpy       python numpy
"

repo=$(cd "$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")/.." && pwd)

# ccache is used where it is installed. Precompiled headers need this sloppiness.
if command -v ccache >/dev/null; then
  export CMAKE_CXX_COMPILER_LAUNCHER=${CMAKE_CXX_COMPILER_LAUNCHER-ccache}
  export CCACHE_SLOPPINESS=${CCACHE_SLOPPINESS-pch_defines,time_macros}
fi

say() { echo "planish: $*" >&2; }

is_there() { # package, kind of probe, thing to probe for
  if [[ $2 == program ]]; then
    command -v "$3" >/dev/null
  elif command -v dpkg-query >/dev/null; then
    [[ $(dpkg-query -W -f '${db:Status-Status}' "$1" 2>/dev/null) == installed ]]
  elif [[ $2 == command ]]; then
    command -v "$3" >/dev/null
  elif [[ $2 == python ]]; then
    /usr/bin/python3 -c "import $3" 2>/dev/null
  else
    echo "#include <$3>" | g++ -E -x c++ - >/dev/null 2>&1
  fi
}

install_packages() { # tables as above
  local package kind thing missing=()
  while read -r package kind thing; do
    [[ -z $package ]] || is_there "$package" "$kind" "$thing" || missing+=("$package")
  done <<<"$*"
  [[ ${#missing[@]} -gt 0 ]] || return 0

  if ! command -v apt-get >/dev/null; then
    say "missing on this system: ${missing[*]} (names as in Debian 12)."
    say "There is no apt-get to install them with: install them by hand and try again."
    exit 1
  fi
  local as_root=()
  if [[ $(id -u) != 0 ]]; then
    if ! command -v sudo >/dev/null; then
      say "missing: ${missing[*]}. Neither root nor sudo is at hand to install them."
      exit 1
    fi
    as_root=(sudo)
  fi
  say "installing ${missing[*]} (log: build/install.log)"
  local log=$repo/build/install.log
  local apt=("${as_root[@]}" env DEBIAN_FRONTEND=noninteractive apt-get -y)
  mkdir -p "$repo/build"
  # The package lists of a bare machine are empty or old: then the first try fails.
  "${apt[@]}" install --no-install-recommends "${missing[@]}" >"$log" 2>&1 && return 0
  { "${apt[@]}" update && "${apt[@]}" install --no-install-recommends "${missing[@]}"; } \
    >"$log" 2>&1 || { cat "$log" >&2 && say "could not install ${missing[*]}" && exit 1; }
}

# What the report pages are bundled with. Where it cannot be had, they are built without 3D view.
install_page_tools() {
  (install_packages "$page_packages") && install_npm web report --omit=dev ||
    say "without Node.js and its packages, reports have still pictures only"
}

# What type-checks and lints web/, for scripts/test only. Where it cannot be had, these tests are skipped.
install_web_tools() {
  install_npm web web || true
}

# Installs what a package.json names, as its lock file has it, under build/npm/NAME. Where that
# cannot be, what needs it is left out by itself.
install_npm() { # folder of package.json, NAME, flags of npm
  local from=$repo/$1 to=$repo/build/npm/$2 flags=("${@:3}")
  cmp -s "$from/package-lock.json" "$to/installed" && return 0
  say "installing Node packages of $1 (log: build/npm-$2.log)"
  mkdir -p "$to"
  cp "$from/package.json" "$from/package-lock.json" "$to"
  if npm ci --prefix "$to" --ignore-scripts --no-audit --no-fund "${flags[@]}" >"$repo/build/npm-$2.log" 2>&1; then
    cp "$from/package-lock.json" "$to/installed"
  else
    say "npm could not install them: what needs them is left out"
    return 1
  fi
}

# Builds a preset, without a word where nothing is to be done and with the whole log where it fails.
build_preset() { # preset, targets (default: all)
  local preset=$1 && shift
  local folder=$repo/build/$preset log=$repo/build/$preset.log
  mkdir -p "$repo/build"
  # What is bundled into the program is looked for when CMake runs.
  if [[ ! -f $folder/build.ninja || $repo/build/npm/report/installed -nt $folder/build.ninja ]]; then
    (cd "$repo" && cmake --preset "$preset") >"$log" 2>&1 || { cat "$log" >&2 && exit 1; }
  fi
  local dry
  dry=$(ninja -C "$folder" -n "$@" 2>/dev/null || true)
  [[ $dry == *"no work to do"* ]] && return 0
  say "building $preset (log: build/$preset.log)"
  cmake --build "$folder" -j "$(nproc)" ${*:+--target "$@"} >"$log" 2>&1 ||
    { cat "$log" >&2 && say "the build failed" && exit 1; }
}

# Format, layers and docs: what needs no build.
check_sources() {
  local failed=0
  say "checking format, layers and docs"
  find apps bench examples include src tests -name '*.h' -print0 -o -name '*.cpp' -print0 |
    xargs -0 clang-format-14 --dry-run -Werror >&2 || failed=1
  python3 tools/check_layers.py >&2 || failed=1
  python3 tools/rooms.py --check >&2 || failed=1
  python3 tools/check_docs.py >&2 || failed=1
  return "$failed"
}
