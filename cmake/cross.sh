# Builds for other systems, and their tests by what stands in for these: a part of ./dev, which has the functions used here.
# docs/platforms.md tells what is offered.

cross_packages=(dpkg-dev libeigen3-dev libfmt-dev libosmesa6-dev libcli11-dev nlohmann-json3-dev python3-venv ninja-build cmake ccache)
windows_packages=(g++-mingw-w64-x86-64-posix mingw-w64-tools llvm wine64)
arm_packages=(qemu-user libc6-arm64-cross)

# Systems, by the tags of MuJoCo's packages for them, and what the library inside is called and must be.
cross_mujoco() {
  case $1 in
    windows) echo win_amd64 mujoco.dll 64ce148d1bca62e18d49aac75226d2159722cacbb1ebcc8d73607e08be10cffe ;;
    linux-x86_64) echo manylinux2014_x86_64 libmujoco.so.2.2.2 63bb16223b4ef9b86485aea53a9c83d61506ed3131dfd4b62c001f24809d4d61 ;;
    linux-aarch64) echo manylinux2014_aarch64 libmujoco.so.2.2.2 9ac8aeeaa52be799378730b7bf74e05251ba79ce52304e737c56777486ee4a60 ;;
    macos-arm64) echo macosx_11_0_arm64 libmujoco.2.2.2.dylib 26123970e75c4a9232e0fe94a785dc0bdad117ba38ece1ed2789a2e6401f914b ;;
    macos-x86_64) echo macosx_10_16_x86_64 libmujoco.2.2.2.dylib 26a88e2629e433ce24303ba367706bbf3fc343ea55ac7e25d7f0aa0feb237d67 ;;
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
# Highway is newer than Debian 12's, which needs ARM's cryptography.
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
  "$cross/python/bin/pip" install -q ziglang==0.13.0 || fail "zig cannot be fetched"
  (cd "$cross" && ln -s python/lib/python3.*/site-packages/ziglang/zig zig)
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

# The C tests by qemu, and the same bytes as on x86-64: both compiled by zig, on MuJoCo's own builds.
test_arm() {
  need "${arm_packages[@]}"
  build_for linux-x86_64 capi_same
  build_for linux-aarch64
  ctest --preset linux-aarch64 --parallel "$(nproc)"
  echo "The same bytes on ARM"
  diff <(build-linux-x86_64/bin/capi_same) <(qemu-aarch64 -L /usr/aarch64-linux-gnu build-linux-aarch64/bin/capi_same) ||
    fail "ARM gives other bytes"
}
