# Tarballs of a static program. Sourced behind scripts/packages.sh.

tarball_packages="
binutils            command readelf
dpkg-dev            command dpkg-source
"

# Debian's packages whose code is in the program: their licences go with it.
tarball_parts="libc6-dev libeigen3-dev libfast-float-dev libpng-dev libpolyclipping-dev
  libstdc++-12-dev nlohmann-json3-dev zlib1g-dev"

make_tarball() { # folder of the build, processor, strip program, program
  local name part folder
  name=planish-$(package_version "$1")-linux-$2
  folder=$packages/$name
  rm -rf "$folder" "$folder.tar.gz"
  install_component "$1" program "$folder" || return 1
  "$3" -o "$folder/bin/planish" "$4"
  if readelf -d "$folder/bin/planish" | grep -q NEEDED; then
    say "$name needs libraries of the system" && return 1
  fi
  cp LICENSE NOTICE packaging/tarball/README "$folder"
  mkdir "$folder/licenses"
  for part in $tarball_parts; do
    cp "/usr/share/doc/$part/copyright" "$folder/licenses/$part"
  done
  set_times "$folder"
  tar --create --sort=name --owner=0 --group=0 --numeric-owner --directory "$packages" "$name" |
    gzip -9n >"$folder.tar.gz"
  rm -r "$folder"
  ls -l "$folder.tar.gz" >&2
}
