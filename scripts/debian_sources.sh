# Debian's sources, for libraries that have to be built for another system or with another compiler.
# Sourced behind scripts/common.sh.

# apt with package lists of its own under build/apt, so that those of the system stay as they are.
own_apt() { # arguments of apt-get
  local top=$repo/build/apt
  local parts=$top/parts
  mkdir -p "$parts" "$top/lists" "$top/cache"
  if [[ ! -f $parts/all.sources ]]; then
    sed 's/^Types:.*/Types: deb deb-src/' /etc/apt/sources.list.d/debian.sources >"$parts/all.sources"
    own_apt update >"$top/update.log" 2>&1
  fi
  apt-get -o Dir::Etc::sourcelist=/dev/null -o "Dir::Etc::sourceparts=$parts" \
    -o "Dir::State::lists=$top/lists" -o "Dir::Cache=$top/cache" \
    -o APT::Architectures::=amd64 -o APT::Architectures::=arm64 "$@"
}

# Unpacks a source package in FOLDER, unless it is there. A mirror may lack the newest security
# update: then that of the release is taken.
unpack_source() { # package, FOLDER; prints the folder of its sources
  local release
  release=$(sed -n 's/^VERSION_CODENAME=//p' /etc/os-release)
  mkdir -p "$2"
  (cd "$2" && ! compgen -G "*/" && { own_apt source "$1" || own_apt source -t "$release" "$1"; }) \
    >"$2.log" 2>&1 || true
  compgen -G "$2/*/" || { cat "$2.log" >&2 && say "could not get the source package $1" && return 1; }
}

# Clipper as a static library, in FOLDER/lib and FOLDER/include.
make_clipper() { # FOLDER, archiver, compiler and its flags
  local folder=$1 archiver=$2 sources && shift 2
  [[ ! -f $folder/lib/libpolyclipping.a ]] || return 0
  mkdir -p "$folder/lib" "$folder/include/polyclipping"
  sources=$(unpack_source libpolyclipping "$folder/sources/polyclipping") || return 1
  cp "$sources/cpp/clipper.hpp" "$folder/include/polyclipping"
  "$@" -O2 -ffp-contract=off -w -c "$sources/cpp/clipper.cpp" -o "$folder/sources/clipper.o" &&
    "$archiver" rcs "$folder/lib/libpolyclipping.a" "$folder/sources/clipper.o"
}
