# What users of all systems get, out of builds for these (cmake/cross.sh): a part of ./dev, which has the functions used here.
# Whatever is made holds libmimo, its MuJoCo, and the licences of all that is inside.

# Who answers for the packages.
contact="libmimo contributors <libmimo@users.noreply.example.org>"

# How the kinds of packages call a system: Python's wheels, NuGet, Rust.
python_tag() {
  case $1 in
    linux) echo manylinux_2_28_x86_64 ;;
    arm) echo manylinux_2_28_aarch64 ;;
    windows) echo win_amd64 ;;
    macos) echo macosx_11_0_arm64 ;;
    macos-x86) echo macosx_11_0_x86_64 ;;
  esac
}

nuget_name() {
  case $1 in
    linux) echo linux-x64 ;;
    arm) echo linux-arm64 ;;
    windows) echo win-x64 ;;
    macos) echo osx-arm64 ;;
    macos-x86) echo osx-x64 ;;
  esac
}

rust_condition() {
  case $1 in
    linux) echo 'all(target_os = "linux", target_env = "gnu", target_arch = "x86_64")' ;;
    arm) echo 'all(target_os = "linux", target_env = "gnu", target_arch = "aarch64")' ;;
    windows) echo 'all(windows, target_arch = "x86_64")' ;;
    macos) echo 'all(target_os = "macos", target_arch = "aarch64")' ;;
    macos-x86) echo 'all(target_os = "macos", target_arch = "x86_64")' ;;
  esac
}

# natives SYSTEM: the libraries of a build for a system, ours first, by the names that programs ask for.
natives() {
  case $1 in
    linux | arm) echo "build-$1/lib/libmimo.so.1 build-$1/lib/libmujoco.so.2.2.2" ;;
    windows) echo build-windows/bin/mimo.dll build-windows/bin/mujoco-2.2.2.dll ;;
    macos | macos-x86) echo "build-$1/lib/libmimo.dylib build-$1/lib/libmujoco.2.2.2.dylib" ;;
  esac
}

# licences SYSTEM FOLDER: of all that is inside the libraries and the program for a system, and the texts that these name.
licences() {
  local to=$2 zig name text
  zig=$(echo build/cross/python/lib/python3*/site-packages/ziglang)
  rm -rf "$to"
  mkdir -p "$to/texts"
  cp LICENSE build/cross/licences/*.txt "$to"
  cp "build/cross/mujoco/$1/LICENSE" "$to/mujoco.txt"
  cp "build/cross/mujoco/$1/LICENSES_THIRD_PARTY.md" "$to/mujoco-third-party.md"
  for name in libeigen3-dev libfmt-dev libcli11-dev nlohmann-json3-dev; do
    cp "/usr/share/doc/$name/copyright" "$to/$(sed -E 's/^lib|3?-dev$//g' <<<"$name").txt"
  done
  if [[ $1 == windows ]]; then
    cp /usr/share/doc/g++-mingw-w64-x86-64-posix/copyright "$to/gcc-mingw.txt"
    cp /usr/share/doc/mingw-w64-x86-64-dev/copyright "$to/mingw-w64.txt"
  else
    cp "$zig/lib/libcxx/LICENSE.TXT" "$to/libcxx.txt"
    cp "$zig/LICENSE" "$to/zig.txt"
  fi
  cat "$to"/*.txt | grep -ohE '/usr/share/common-licenses/[A-Za-z0-9.+-]*[A-Za-z0-9]' | sort -u | while read -r text; do
    cp "$text" "$to/texts/$(basename "$text").txt"
  done
}

# each_system DO SYSTEM|all: does something for one system or for all of them.
each_system() {
  local system known=$systems
  [[ $2 == all ]] || known=$2
  [[ " $systems all " == *" $2 "* ]] || fail "no platform '$2'; there are: $systems all"
  for system in $known; do "$1" "$system"; done
}

version_text() {
  sed -nE 's/^#define MIMO_VERSION_(MAJOR|MINOR|PATCH|LABEL) +"?([^" ]*)"? .*/\2/p' include/mimo/status.h |
    paste -sd' ' | awk '{ print $1 "." $2 "." $3 $4 }'
}

# ---- Packages that come out the same each time ----------------------------------------------------------------

# The time that all files in packages have: the last commit's. A source tarball's files have it already.
date_packages() {
  [[ -z ${SOURCE_DATE_EPOCH:-} ]] || return 0
  SOURCE_DATE_EPOCH=$(git log -1 --format=%ct 2>/dev/null || stat --format %Y CHANGELOG.md)
  export SOURCE_DATE_EPOCH
}

# pack OUT.tar.gz|OUT.zip FOLDER NAME [--files]
pack() { "$(system_python)" cmake/pack.py "$@"; }

# ---- Debian -------------------------------------------------------------------------------------------------

# The packages that cmake/debian/control lists. What they hold is compiled as the release build is, so ccache has it.
package_debian() {
  local folder=build/debian version
  build debian mimo mimo_program
  version=$(version_text)
  rm -rf "$folder"
  mkdir -p "$folder/tree"
  cp -r cmake/debian CHANGELOG.md "$folder/tree/"
  cp LICENSE "$folder/tree/debian/copyright"
  sed -i "s/@MIMO_CONTACT@/$contact/" "$folder/tree/debian/control"
  printf 'libmimo (%s-1) unstable; urgency=medium\n\n  * Release %s; the changelog of libmimo says what is new.\n\n -- %s  %s\n' \
    "${version/-/\~}" "$version" "$contact" "$(date --utc --rfc-email --date "@$SOURCE_DATE_EPOCH")" >"$folder/tree/debian/changelog"
  (cd "$folder/tree" && MIMO_BUILD=$OLDPWD/build-debian DEB_BUILD_OPTIONS=noautodbgsym \
    dpkg-buildpackage --build=binary --no-sign --no-check-builddeps) >"$folder/log" 2>&1 ||
    { tail -n 30 "$folder/log"; fail "the Debian packages could not be made; $folder/log says why"; }
  cp "$folder"/*.deb build/package/
}

# ---- What is inside -------------------------------------------------------------------------------------------

# collect SYSTEM: what was built for it, in build/release/SYSTEM: the libraries that programs load, the program, the licences.
collect() {
  local to=build/release/$1 library
  build_for "$1" mimo mimo_program
  rm -rf "$to"
  mkdir -p "$to/libraries" "$to/program"
  for library in $(natives "$1"); do cp --dereference "$library" "$to/libraries/"; done
  for library in "build-$1"/bin/mimo{,.exe}; do [[ ! -f $library ]] || cp "$library" "$to/program/"; done
  licences "$1" "$to/licences"
}

# ---- Python -------------------------------------------------------------------------------------------------

# The tag promises where pip may install it.
wheel_for() {
  local native=$PWD/build/release/$1/native
  collect "$1"
  mkdir -p "$native"
  cp "build/release/$1"/{libraries,program}/* "$native/"
  make_wheel bindings/python "$native" "$PWD/build/release/$1/licences" "$(python_tag "$1")"
  rm -rf "$native"
}

# make_wheel SOURCES FILES LICENCES TAG: FILES are what is native in it.
make_wheel() {
  local made=build/release/wheel
  date_packages
  echo "Wheel of $1 for $4"
  [[ -x build/release/python/bin/auditwheel ]] || { new_venv release/python && install_pinned release/python build; }
  rm -rf "$made" build/release/python-build
  mkdir -p build/wheel
  build/release/python/bin/pip wheel -q --no-deps --no-build-isolation "./$1" -w "$made" \
    --config-settings=build-dir="$PWD/build/release/python-build" --config-settings=cmake.define.MIMO_PREBUILT="$2" \
    --config-settings=cmake.define.MIMO_LICENCES="$3"
  build/release/python/bin/wheel tags --remove --platform-tag "$4" "$made"/*.whl >/dev/null
  mv "$made"/*.whl build/wheel/
}

# For programs that use the package mujoco: the library alone, which finds MuJoCo where mujoco-core keeps it.
wheel_for_mujoco4() {
  local native=$PWD/build/release/mujoco4
  need patchelf
  fetch_mujoco4
  prepare_build linux
  cmake --preset linux-mujoco4 >/dev/null
  cmake --build --preset linux-mujoco4 --target mimo
  licences linux build/release/licences
  rm -rf build/release/licences/mujoco* "$native"
  mkdir -p "$native"
  cp --dereference build-linux-mujoco4/lib/libmimo.so.1 "$native/"
  patchelf --set-rpath '$ORIGIN/../mujoco' "$native/libmimo.so.1"
  make_wheel bindings/python-mujoco4 "$native" "$PWD/build/release/licences" "$(python_tag linux)"
}

# ---- C and C++ ----------------------------------------------------------------------------------------------

# What `cmake --install` installs, MuJoCo and the licences beside it: unpacked anywhere it works.
archive_for() {
  local name root
  name=libmimo-$(version_text)-$(nuget_name "$1")
  root=build/release/$name
  rm -rf "$root"
  cmake --install "build-$1" --prefix "$root" >/dev/null
  cp -P "$(cut -d' ' -f2 <<<"$(natives "$1")")" "$root/$([[ $1 == windows ]] && echo bin || echo lib)/"
  cp -r "build/release/$1/licences" "$root/"
  pack "build/package/$name.$([[ $1 == windows ]] && echo zip || echo tar.gz)" "$root" "$name"
  rm -rf "$root"
}

# ---- C# -----------------------------------------------------------------------------------------------------

package_csharp() {
  local system named=() version
  version=$(version_text)
  need patchelf
  build_csharp
  for system in $systems; do named+=("$(nuget_name "$system")=build/release/$system"); done
  "$(system_python)" bindings/csharp/package/make_nuget.py "$version" build/csharp "build/package/Mimo.$version.nupkg" "${named[@]}"
  "$(system_python)" bindings/csharp/package/make_unity.py "$version" "build/package/org.libmimo.mimo-$version.tgz" "${named[@]}"
}

# ---- Rust ---------------------------------------------------------------------------------------------------

# The crate of a system's library. Those of the bindings depend on all of them, each for its target.
native_crate() {
  local name crate
  name=$(nuget_name "$1")
  crate=build/release/crates/mimo-native-$name
  mkdir -p "$crate"
  cp -r bindings/rust/native/{build.rs,src,README.md} LICENSE "build/release/$1"/{libraries,licences} "$crate/"
  sed "s/SYSTEM/$name/; s/VERSION/$(version_text)/; s/LINKS/${name//-/_}/" bindings/rust/native/Cargo.toml.in >"$crate/Cargo.toml"
  [[ $1 != windows ]] || cp build-windows/lib/{libmimo.dll.a,mimo.lib} "$crate/libraries/"
  {
    echo
    echo "[target.'cfg($(rust_condition "$1"))'.dependencies]"
    echo "mimo-native-$name = { path = \"../mimo-native-$name\", version = \"=$(version_text)\", optional = true }"
  } >>build/release/crates/mimo-sys/Cargo.toml
}

# The crates as a registry gets them: with `bundled` the library comes along instead of being built. The examples stay in
# the repository.
package_rust() {
  local crates=build/release/crates system native='' crate patches=()
  need "${rust_packages[@]}"
  rm -rf "$crates"
  mkdir -p "$crates"
  cp -rL bindings/rust/mimo-sys bindings/rust/mimo "$crates/"
  # A registry shows the page alone: what it leads to stays in the repository.
  sed -E 's/\[([^]]*)\]\(\.\.\/[^)]*\)/\1/g' bindings/rust/README.md >"$crates/mimo/README.md"
  sed -i '/^\[\[example/,$d; s|^readme = .*|readme = "README.md"|' "$crates/mimo/Cargo.toml"
  for system in $systems; do native+="\"mimo-native-$(nuget_name "$system")\", "; done
  sed -i "s/^bundled = \[\]/bundled = [${native%, }]/" "$crates/mimo-sys/Cargo.toml"
  for system in $systems; do native_crate "$system"; done
  printf '[workspace]\nmembers = ["mimo*"]\nresolver = "2"\n' >"$crates/Cargo.toml"
  for crate in "$crates"/mimo-*/; do patches+=(--config "patch.crates-io.$(basename "$crate").path='$(basename "$crate")'"); done
  (cd "$crates" && for crate in mimo-native-* mimo-sys mimo; do
    cargo package -q --offline --no-verify --allow-dirty -p "$crate" "${patches[@]}" || fail "the crate $crate cannot be packaged"
  done)
  cp "$crates"/target/package/*.crate build/package/
}

# seal_packages FOLDER: what is inside the packages that lie there, and their hashes.
seal_packages() {
  "$(system_python)" cmake/bill.py "$(version_text)" "$1" build/cross/sources.txt "$1/libmimo-$(version_text).spdx.json"
  (cd "$1" && LC_ALL=C && sha256sum -- *[!S] >SHA256SUMS)
}

make_packages() {
  package
  [[ $* != --all ]] || make_packages_of_all_systems
  [[ $# == 0 || $* == --all ]] || fail "expected --all or nothing, not '$*'"
  seal_packages build/package
}

make_packages_of_all_systems() {
  each_system wheel_for all
  wheel_for_mujoco4
  each_system archive_for all
  cp build/wheel/mimo*.whl build/package/
  package_csharp
  package_rust
}

# check_same_packages [--all]: made once more, the packages are the same files.
check_same_packages() {
  rm -rf build/package-first
  mv build/package build/package-first
  make_packages "$@"
  diff build/package-first/SHA256SUMS build/package/SHA256SUMS || fail "made twice, packages differ"
  rm -rf build/package-first
  echo "Made twice, the packages are the same"
}

test_release() {
  local version
  version=$(version_text)
  need file clang binutils
  make_packages --all
  echo "Tests of the packages for all systems"
  tests/package/check_archive "build/package/libmimo-$version-linux-x64.tar.gz"
  tests/package/check_msvc "build/package/libmimo-$version-win-x64.zip"
  tests/package/check_macos "build/package/libmimo-$version-osx-arm64.tar.gz" arm64
  tests/package/check_macos "build/package/libmimo-$version-osx-x64.tar.gz" x86_64
  fetch_dotnet linux
  tests/package/check_nuget "build/package/Mimo.$version.nupkg" build/dotnet/linux/dotnet
  tests/package/check_unity "build/package/org.libmimo.mimo-$version.tgz"
  tests/package/check_crates "build/package/mimo-$version.crate" build/package
  check_same_packages --all
}
