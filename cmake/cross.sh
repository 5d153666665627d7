# Builds for other systems, and their tests by what stands in for these: a part of ./dev, which has the functions used here.
# docs/platforms.md tells what is offered.

cross_packages=(dpkg-dev libeigen3-dev libfmt-dev libosmesa6-dev libcli11-dev nlohmann-json3-dev python3-venv ninja-build cmake ccache)
windows_packages=(g++-mingw-w64-x86-64-posix mingw-w64-tools llvm wine64)
arm_packages=(qemu-user libc6-arm64-cross libgcc-s1-arm64-cross)
linux_packages=(debootstrap)

systems="linux arm windows macos macos-x86"

# Systems, by the tags of MuJoCo's packages for them, and what the library inside is called and must be.
cross_mujoco() {
  case $1 in
    linux) echo manylinux2014_x86_64 libmujoco.so.2.2.2 63bb16223b4ef9b86485aea53a9c83d61506ed3131dfd4b62c001f24809d4d61 ;;
    arm) echo manylinux2014_aarch64 libmujoco.so.2.2.2 9ac8aeeaa52be799378730b7bf74e05251ba79ce52304e737c56777486ee4a60 ;;
    windows) echo win_amd64 mujoco.dll 64ce148d1bca62e18d49aac75226d2159722cacbb1ebcc8d73607e08be10cffe ;;
    macos) echo macosx_11_0_arm64 libmujoco.2.2.2.dylib 26123970e75c4a9232e0fe94a785dc0bdad117ba38ece1ed2789a2e6401f914b ;;
    macos-x86) echo macosx_10_12_x86_64 libmujoco.2.2.2.dylib 26a88e2629e433ce24303ba367706bbf3fc343ea55ac7e25d7f0aa0feb237d67 ;;
    *) fail "no system '$1'; there are: $systems" ;;
  esac
}

# What zig calls the systems that it compiles for; with glibc's version, whose later functions are not used.
zig_target() {
  case $1 in
    linux) echo x86_64-linux-gnu.2.28 ;;
    arm) echo aarch64-linux-gnu.2.28 ;;
    macos) echo aarch64-macos.11.0 ;;
    macos-x86) echo x86_64-macos.11.0 ;;
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
  basename --multiple "$cross"/sources/*-[0-9]*/ >"$cross/sources.txt"
  mv "$cross"/sources/highway-*/hwy "$cross/include/"
  mkdir -p "$cross/licences"
  for folder in highway pugixml libpng zlib; do cp "$cross/sources/$folder"*-[0-9]*/debian/copyright "$cross/licences/$folder.txt"; done
  for folder in pugixml zlib libpng; do mv "$cross/sources/$folder"*-[0-9]*/ "$cross/$folder"; done
  cp "$cross/libpng/scripts/pnglibconf.h.prebuilt" "$cross/libpng/pnglibconf.h"
  rm -rf "$cross/sources"
  new_venv cross/python
  install_pinned cross/python zig
  touch "$cross/complete"
}

# zig's tools as programs of one word each, as CMake and ccache want them, in build/cross/zig/SYSTEM. Its C library is any
# version's that one names, its C++ library goes into what is linked.
write_zig_tools() {
  local folder=$PWD/build/cross/zig/$1 target tool
  target=$(zig_target "$1")
  [[ -n $target && ! -d $folder ]] || return 0
  mkdir -p "$folder"
  for tool in cc c++ ar ranlib; do
    local further=
    [[ $tool != c* ]] || further="-target $target -fno-sanitize=undefined -g0"
    printf '#!/bin/bash\nexec "%s" %s %s "$@"\n' "$(echo "$PWD"/build/cross/python/lib/python3*/site-packages/ziglang/zig)" \
      "$tool" "$further" >"$folder/$tool"
    chmod +x "$folder/$tool"
  done
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
  # Windows gives a library of a name that a program has already to all who ask for it, whichever it is.
  [[ $1 != windows ]] || (cd build/cross/mujoco/new && mv mujoco.dll mujoco-2.2.2.dll && gendef mujoco-2.2.2.dll >/dev/null 2>&1 &&
    x86_64-w64-mingw32-dlltool -d mujoco-2.2.2.def -l libmujoco.dll.a -D mujoco-2.2.2.dll)
  if [[ $1 == macos* ]]; then  # it says of itself that it lies in a framework, and no longer runs when it says otherwise
    mkdir build/cross/mujoco/new/signed
    cp "build/cross/mujoco/new/$library" build/cross/mujoco/new/signed/
    llvm-install-name-tool-14 -id "@rpath/$library" "build/cross/mujoco/new/$library"
  fi
  mv build/cross/mujoco/new "$folder"
  rm -rf build/cross/wheel
}

# What a build for a system needs.
prepare_build() {
  need "${cross_packages[@]}"
  [[ $1 != windows ]] || need "${windows_packages[@]}"
  [[ $1 != arm ]] || need "${arm_packages[@]}"
  [[ $1 != macos* ]] || need llvm
  fetch_dependencies
  fetch_cross_mujoco "$1"
  write_zig_tools "$1"
}

# build_for SYSTEM [TARGET...]: by the CMake preset of that name.
build_for() {
  prepare_build "$1"
  cmake --preset "$1" >/dev/null
  cmake --build --preset "$1" ${2:+--target "${@:2}"}
}

# ---- Tests ------------------------------------------------------------------------------------------------

# The C tests of a build, by what stands in for its system.
test_system() {
  build_for "$1"
  echo "Tests, $1"
  ctest --preset "$1" --parallel "$(nproc)"
}

# same_as_here PROGRAM COMMAND...: the build for any Linux says here what the command says elsewhere.
same_as_here() {
  local here there
  here=$("$1")
  there=$("${@:2}")
  [[ $here == "$there" ]] || { diff <(echo "$here") <(echo "$there"); fail "other bytes by ${*:2}"; }
  echo "The same bytes by ${*:2}"
}

# foreign_debian FOLDER SUITE ARCHITECTURE: files of another release, or for another processor, with Python; nothing of it is
# installed, and programs are told where to look.
foreign_debian() {
  local folder=$1 package
  [[ ! -f $folder/complete ]] || return 0
  need debootstrap
  rm -rf "$folder"
  echo "Fetching Debian $2 for $3"
  debootstrap --download-only --arch "$3" --variant minbase --include python3 "$2" "$folder" >"$folder.log" 2>&1 ||
    fail "Debian $2 for $3 cannot be fetched; $folder.log says why"
  for package in "$folder"/var/cache/apt/archives/*.deb; do dpkg-deb --extract "$package" "$folder"; done
  rm -rf "$folder"/var/cache/apt/archives
  mkdir -p "$folder/opt"
  touch "$folder/complete"
}

# put_wheel SYSTEM PYTHON FOLDER [LIST]: the wheel that wheel_for made for a system, and what it needs for that Python, chosen
# by their tags out of cmake/pins/LIST.txt, by default run-PYTHON.txt.
put_wheel() {
  local own tag platforms=()
  own=$(python_tag "$1")
  for tag in "$own" "${own/manylinux_2_28/manylinux2014}" "${own/manylinux_2_28/manylinux_2_27}"; do platforms+=(--platform "$tag"); done
  rm -rf "$3"
  build/release/python/bin/pip install -q --target "$3" --implementation cp --python-version "$2" --only-binary=:all: \
    "${platforms[@]}" --no-deps --require-hashes -r "cmake/pins/${4:-run-$2}.txt"
  build/release/python/bin/pip install -q --target "$3" --implementation cp --python-version "$2" --only-binary=:all: \
    "${platforms[@]}" --no-deps build/wheel/mimo-*-"$own".whl
}

python_version() {
  "$(system_python)" -c 'import sys; print("%d.%d" % sys.version_info[:2])'
}

# What a newcomer's first steps say with the wheel for any Linux; test_linux and test_arm put it where this looks.
first_steps() {
  PYTHONPATH=build/release/packages "$(system_python)" tests/package/first_steps.py
}

# Releases of 2021 and 2025, whose C libraries are 2.31 and 2.41: the same numbers there as here.
test_elsewhere() {
  local suite=$1 version=$2 root=$PWD/build/release/$1
  foreign_debian "$root" "$suite" amd64
  cp tests/package/first_steps.py build-linux/bin/capi_same build-linux/lib/lib{mimo.so.1,mujoco.so.2.2.2} "$root/opt/"
  same_as_here build-linux/bin/capi_same chroot "$root" env LD_LIBRARY_PATH=/opt /opt/capi_same
  put_wheel linux "$version" "$root/opt/packages"
  same_as_here first_steps chroot "$root" env PYTHONPATH=/opt/packages /usr/bin/python3 /opt/first_steps.py
  chroot "$root" env LD_LIBRARY_PATH=/opt/packages/mimo/_native /opt/packages/mimo/_native/mimo info >/dev/null  # no /proc
}

# The wheel's tag is asked of its symbols.
test_linux() {
  local said
  test_system linux
  wheel_for linux
  put_wheel linux "$(python_version)" build/release/packages
  build/release/python/bin/auditwheel show build/wheel/mimo-*manylinux_2_28_x86_64.whl | tr '\n' ' ' |
    grep -o 'consistent with *the following platform tag: *"manylinux_2_[0-9]*_x86_64"' || fail "auditwheel does not confirm the wheel's tag"
  test_elsewhere bullseye 3.9
  test_elsewhere trixie 3.13
  # A processor of 2008 has no AVX.
  need qemu-user
  said=$(qemu-x86_64 -cpu Nehalem build-linux/bin/mimo run --seconds 0.1 2>&1) && fail "MuJoCo runs without AVX"
  [[ $said == *"has no AVX"* ]] || fail "without AVX the program says: $said"
}

# Debian's MuJoCo and that for ARM are both compiled for what all their processors have, and give the same numbers.
test_arm() {
  need "${arm_packages[@]}"
  test_system arm
  build release capi_same
  use_mujoco
  same_as_here build/bin/capi_same qemu-aarch64 -L /usr/aarch64-linux-gnu build-arm/bin/capi_same
  local root=$PWD/build/release/debian-arm
  foreign_debian "$root" bookworm arm64
  wheel_for linux
  wheel_for arm
  put_wheel linux "$(python_version)" build/release/packages
  put_wheel arm 3.11 "$root/opt/packages"
  same_as_here first_steps qemu-aarch64 -L "$root" -E PYTHONPATH="$root/opt/packages" "$root/usr/bin/python3" tests/package/first_steps.py
  qemu-aarch64 -L "$root" "$root/opt/packages/mimo/_native/mimo" info >/dev/null
}

# Python for Windows, in FOLDER: the one that Java programs embed, which a registry has as an archive.
windows_python() {
  local archive=cpython-3.11.3-1.5.9-windows-x86_64.jar
  [[ ! -x $1/python.exe ]] || return 0
  need maven
  rm -rf build/release/maven
  mvn -q -B org.apache.maven.plugins:maven-dependency-plugin:3.6.1:copy -DoutputDirectory="$PWD/build/release/maven" \
    -Dartifact=org.bytedeco:cpython:3.11.3-1.5.9:jar:windows-x86_64 || fail "Python for Windows cannot be fetched"
  sha256sum --quiet -c <<<"3263a50b256447bb7b9e604d6587627e419891370fc33b94469e6a06ff4de834  build/release/maven/$archive" ||
    fail "$archive is not the one that is expected"
  "$(system_python)" -m zipfile -e "build/release/maven/$archive" build/release/maven
  rm -rf "$1"
  mv build/release/maven/org/bytedeco/cpython/windows-x86_64 "$1"
  cp "$1"/lib/vcruntime140*.dll "$1/"
  rm -rf build/release/maven
}

# on_windows PATH: what Windows' programs call it under wine.
on_windows() { echo "Z:${1//\//\\}"; }

# windows_program PROGRAM ARGUMENTS...: by wine, whose line endings are Windows'. Python there takes pipes only.
windows_program() {
  /usr/lib/wine/wine64 "$@" </dev/null 2>&1 | tr -d '\r'
}

# Pictures are those of the build for any Linux, byte by byte: the renderer's vectors lie on a stack that Windows aligns less.
same_pictures_on_windows() {
  local pictures=$PWD/build-windows/pictures run=(run --scene benchmark --seconds 0.05 --seed 3 --vision 64 --out)
  build_for linux mimo mimo_program  # on the same MuJoCo
  rm -rf "$pictures"
  windows_program build-windows/bin/mimo.exe "${run[@]}" "$pictures/windows" >/dev/null
  build-linux/bin/mimo "${run[@]}" "$pictures/here" >/dev/null
  diff -r "$pictures/here" "$pictures/windows" || fail "Windows draws other pictures"
  echo "The same pictures on Windows"
}

# By Windows' .NET, with the HDF5 that the wheel's packages brought.
test_csharp_on_windows() {
  csharp_tests WindowsTests.exe -define:WINDOWS
  fetch_dotnet windows
  echo "Tests of the C# classes on Windows"
  WINEPATH=$(on_windows "$PWD/build-windows/bin") \
    MIMO_HDF5=$(on_windows "$PWD/build/release/python-windows/packages/h5py/hdf5.dll") \
    windows_program build/dotnet/windows/dotnet.exe exec --runtimeconfig tests/package/dotnet.json \
    build/csharp/WindowsTests.exe --all
}

# python_on_windows PACKAGES ARGUMENTS...: Windows' Python, with a folder of packages.
python_on_windows() {
  local python=$PWD/build/release/python-windows
  PYTHONHOME=$(on_windows "$python") PYTHONPATH="$(on_windows "$python/lib");$(on_windows "$1")" \
    windows_program "$python/python.exe" "${@:2}"
}

test_wheel_on_windows() {
  local python=$PWD/build/release/python-windows
  windows_python "$python"
  wheel_for linux
  wheel_for windows
  put_wheel linux "$(python_version)" build/release/packages
  put_wheel windows 3.11 "$python/packages" wine
  same_as_here first_steps python_on_windows "$python/packages" tests/package/first_steps.py
}

# A MuJoCo of another version: in the program already, it is left alone; in the place of ours, it is refused.
test_other_mujoco_on_windows() {
  local other=$PWD/build-windows/other packages=$PWD/build/release/python-windows/packages said
  mkdir -p "$other/mimo"
  x86_64-w64-mingw32-gcc-posix -shared -o "$other/mujoco.dll" tests/loading/stand_in.c
  said=$(python_on_windows "$packages" -c \
    "import ctypes; assert ctypes.CDLL(r'$(on_windows "$other/mujoco.dll")').mj_version() == 999; import mimo; mimo.make('reach').reset()")
  [[ -z $said ]] || fail "beside another MuJoCo Windows' Python says: $said"
  cp build-windows/bin/mimo.dll "$other/mimo/"
  cp "$other/mujoco.dll" "$other/mimo/mujoco-2.2.2.dll"
  # Windows refuses to load a library whose functions are missing; wine loads it, and libmimo looks at the version.
  said=$(MIMO_LIBRARY=$(on_windows "$other/mimo/mimo.dll") python_on_windows "$packages" -c 'import mimo; mimo.make("reach")') &&
    fail "Windows' Python takes another MuJoCo"
  [[ $said == *"libmimo was made for MuJoCo 2.2.2, but got MuJoCo "*"the one that came with it"* ]] ||
    fail "with another MuJoCo Windows' Python says: $said"
  echo "Other MuJoCos are left alone or refused on Windows"
}

# The C tests, the program, the C# classes, a Python wheel.
test_windows() {
  local -x WINEDEBUG=-all WINEPREFIX=$PWD/build-windows/wine
  test_system windows
  windows_program build-windows/bin/mimo.exe --version
  same_pictures_on_windows
  test_wheel_on_windows
  test_csharp_on_windows
  test_other_mujoco_on_windows
}
