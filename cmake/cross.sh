# Builds for other systems, and their tests by what stands in for these: a part of ./dev, which has the functions used here.
# docs/platforms.md tells what is offered.

cross_packages=(dpkg-dev libeigen3-dev libfmt-dev libosmesa6-dev libcli11-dev nlohmann-json3-dev python3-venv ninja-build cmake ccache)
windows_packages=(g++-mingw-w64-x86-64-posix mingw-w64-tools llvm wine64)

# Systems, by the tags of MuJoCo's packages for them, and what the library inside is called and must be.
cross_mujoco() {
  case $1 in
    windows) echo win_amd64 mujoco.dll 64ce148d1bca62e18d49aac75226d2159722cacbb1ebcc8d73607e08be10cffe ;;
    *) fail "no system '$1'" ;;
  esac
}

# fetch_sources SUITE NAME...: Debian's sources, unpacked beside each other. apt checks their signatures; lists of its own
# leave the system's alone.
fetch_sources() {
  local suite=$1 folder=$PWD/build/cross/sources
  shift
  mkdir -p "$folder/lists/partial" "$folder/cache/archives/partial"
  echo "deb-src [signed-by=/usr/share/keyrings/debian-archive-keyring.gpg] http://deb.debian.org/debian $suite main" >"$folder/list"
  local apt=(apt-get -qq -o APT::Sandbox::User=root -o "Dir::Etc::sourcelist=$folder/list" -o Dir::Etc::sourceparts=-
             -o "Dir::State::lists=$folder/lists" -o "Dir::Cache=$folder/cache")
  "${apt[@]}" update
  (cd "$folder" && "${apt[@]}" source "$@" >/dev/null 2>&1) || fail "the sources of $* cannot be fetched"
}

# What builds for all other systems need, in build/cross: headers of the system's that know no system, sources of the rest.
# Highway is newer than Debian 12's.
fetch_dependencies() {
  [[ ! -f build/cross/complete ]] || return 0
  need "${cross_packages[@]}"
  echo "Fetching what builds for other systems need"
  local cross=build/cross folder
  rm -rf "$cross"
  mkdir -p "$cross/include"
  for folder in eigen3/Eigen eigen3/unsupported fmt GL KHR CLI nlohmann; do cp -r "/usr/include/$folder" "$cross/include/"; done
  fetch_sources bookworm pugixml libpng1.6 zlib
  fetch_sources trixie highway
  mv "$cross"/sources/highway-*/hwy "$cross/include/"
  for folder in pugixml zlib libpng; do mv "$cross/sources/$folder"*-[0-9]*/ "$cross/$folder"; done
  cp "$cross/libpng/scripts/pnglibconf.h.prebuilt" "$cross/libpng/pnglibconf.h"
  rm -rf "$cross/sources"
  new_venv cross/python
  touch "$cross/complete"
}

# MuJoCo for a system, in build/cross/mujoco/SYSTEM.
fetch_cross_mujoco() {
  local folder=build/cross/mujoco/$1 tag library sum
  [[ ! -d $folder ]] || return 0
  read -r tag library sum <<<"$(cross_mujoco "$1")"
  rm -rf build/cross/wheel
  build/cross/python/bin/pip download -q --no-deps --only-binary=:all: --python-version 3.10 --platform "$tag" \
    -d build/cross/wheel mujoco==2.2.2 || fail "MuJoCo's Python package for $1 cannot be fetched"
  build/cross/python/bin/python -m zipfile -e build/cross/wheel/*.whl build/cross/wheel
  sha256sum --quiet -c <<<"$sum  build/cross/wheel/mujoco/$library" || fail "$library is not the one that is expected"
  mkdir -p build/cross/mujoco/new
  mv "build/cross/wheel/mujoco/$library" build/cross/wheel/mujoco/include build/cross/wheel/*.dist-info/LICENSE* build/cross/mujoco/new/
  [[ $1 != windows ]] || (cd build/cross/mujoco/new && gendef mujoco.dll >/dev/null 2>&1 &&
    x86_64-w64-mingw32-dlltool -d mujoco.def -l libmujoco.dll.a -D mujoco.dll)
  mv build/cross/mujoco/new "$folder"
  rm -rf build/cross/wheel
}

# build_for SYSTEM [TARGET...]: by the CMake preset of that name.
build_for() {
  fetch_dependencies
  fetch_cross_mujoco "$1"
  cmake --preset "$1" >/dev/null
  cmake --build --preset "$1" ${2:+--target "${@:2}"}
}

build_windows() {
  need "${windows_packages[@]}"
  build_for windows "$@"
}

# The C tests by wine, the program, and pictures that are to be those of this machine, byte by byte: the renderer's vectors
# lie on a stack that Windows aligns less.
test_windows() {
  build_windows
  local -x WINEDEBUG=-all WINEPREFIX=$PWD/build-windows/wine
  local wine=/usr/lib/wine/wine64 pictures=$PWD/build-windows/pictures
  "$wine" build-windows/bin/mimo.exe --version
  ctest --preset windows --parallel "$(nproc)"
  build_program
  use_mujoco --avx  # whose numbers are Windows' build's, but for rounding
  rm -rf "$pictures"
  local run=(run --scene benchmark --seconds 0.05 --seed 3 --vision 64 --out)
  "$wine" build-windows/bin/mimo.exe "${run[@]}" "$pictures/windows" >/dev/null
  build/bin/mimo "${run[@]}" "$pictures/here" >/dev/null
  use_mujoco
  diff -r "$pictures/here" "$pictures/windows" || fail "Windows draws other pictures"
  echo "The same pictures on Windows"
}
