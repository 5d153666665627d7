# Building and testing the bindings other than Python's: a part of ./dev, which has the functions used here.

# follow BINDING: what its README says, step by step.
follow() {
  tests/readme/follow "bindings/$1/README.md" . >/dev/null
  echo "README of bindings/$1 followed"
}

# acyclic WHAT: fails if the pairs of names that it reads, a user and what it uses, go round in a circle.
acyclic() {
  local loop
  loop=$(tsort 2>&1 >/dev/null) || fail "$1 use each other in a circle: $loop"
}

# ---- Rust -------------------------------------------------------------------------------------------------

# rust_refuses MESSAGE VARIABLE...: what a user reads whose libmimo cannot be found.
rust_refuses() {
  local message=$1 said
  shift
  said=$(env -u MIMO_LIB_DIR "$@" cargo build -q -p mimo-sys 2>&1) && fail "Rust finds a library with $*"
  [[ $said == *"$message"* && $said != *panicked* ]] || fail "Rust without a library says: $said"
}

# What a registry would get compiles by itself, and has what it shows.
package_crates() {
  local crate
  for crate in mimo-sys mimo; do
    [[ $(cargo package --list --allow-dirty -p "$crate" | grep -cxE 'LICENSE|README.md') == 2 ]] || fail "$crate has no licence or README"
    cargo package -q --offline --allow-dirty -p "$crate" --config 'patch.crates-io.mimo-sys.path="mimo-sys"'
  done
}

test_rust() {
  need "${rust_packages[@]}"
  # "world.rs" and then "crate::block", each on a line of its own; sys is below all.
  grep -v '^\s*//' bindings/rust/mimo/src/*.rs --with-filename | grep -oE '/\w+\.rs:|crate::[a-z]\w*' |
    awk '/^\// { gsub(/\/|\.rs:/, ""); user = $0; next } { sub(/crate::/, "") } $0 != "sys" { print user, $0 }' |
    acyclic "the modules of the Rust crate"
  build_program
  echo "Tests of the Rust crates"
  local -x MIMO_LIB_DIR=$PWD/build/lib LD_LIBRARY_PATH=$PWD/build/lib CARGO_TARGET_DIR=$PWD/build/rust
  local example
  (
    cd bindings/rust
    rust_refuses 'MIMO_LIB_DIR is "/nowhere", expected' MIMO_LIB_DIR=/nowhere
    rust_refuses 'set MIMO_LIB_DIR to the folder of libmimo.so' PKG_CONFIG_LIBDIR=/nowhere
    cargo fmt --check
    cargo clippy -q --all-targets -- -D warnings
    RUSTDOCFLAGS="-D warnings" cargo doc -q --no-deps
    cargo test -q
    # In a folder beside the others ccache knows all that the crate builds.
    MIMO_BUILD_DIR=$OLDPWD/build-rust MIMO_CMAKE_ARGS="-G Ninja -DMIMO_WERROR=ON" LD_LIBRARY_PATH='' cargo test -q -p mimo-sys --features bundled
    package_crates
    for example in hello batch observe own_reward own_goal; do cargo run -q --example "$example"; done
  )
  follow rust
}

# ---- C# ---------------------------------------------------------------------------------------------------

mcs=(mcs -nologo -langversion:7 -warnaserror)

# csharp_tests PROGRAM [OPTION...] of the compiler
csharp_tests() {
  need "${csharp_packages[@]}"
  mkdir -p build/csharp
  "${mcs[@]}" -nowarn:1591 "${@:2}" -out:"build/csharp/$1" bindings/csharp/src/*.cs bindings/csharp/tests/*.cs
}

# Undocumented public members are warnings of the library, hence errors.
build_csharp() {
  local example
  csharp_tests Tests.exe
  printf '[assembly: System.Reflection.AssemblyVersion("%s.0")]\n[assembly: System.Reflection.AssemblyInformationalVersion("%s")]\n' \
    "$(version_text | cut -d- -f1)" "$(version_text)" >build/csharp/Version.cs
  "${mcs[@]}" -target:library -doc:build/csharp/MimoSharp.xml -out:build/csharp/MimoSharp.dll build/csharp/Version.cs bindings/csharp/src/*.cs
  for example in examples/csharp/*.cs tests/same/*.cs; do
    "${mcs[@]}" -r:build/csharp/MimoSharp.dll -out:"build/csharp/$(basename "$example" .cs).exe" "$example"
  done
}

# Microsoft's .NET (Core 3.1) for linux or windows, in build/dotnet/SYSTEM: a Python package brings it along. It runs what
# Mono's compiler made: dotnet exec --runtimeconfig tests/package/dotnet.json PROGRAM.exe.
fetch_dotnet() {
  local folder=build/dotnet/$1 tag sum
  case $1 in
    linux) tag=manylinux1_x86_64 sum=5f076ddc39da0c685e7de20ecb91ee81185928918ec86fbeb3bffc55dd867ab5 ;;
    windows) tag=win_amd64 sum=e2528813677d7a080522336cb530442408d1e2aea76fa8657018fb532c03c252 ;;
  esac
  [[ ! -d $folder ]] || return 0
  need "${python_packages[@]}"
  [[ -x build/dotnet/bin/pip ]] || new_venv dotnet
  build/dotnet/bin/pip download -q --no-deps --only-binary=:all: --platform "$tag" -d build/dotnet dotnetcore2==3.1.23 ||
    fail ".NET for $1 cannot be fetched"
  sha256sum --quiet -c <<<"$sum  $(echo build/dotnet/*"$tag".whl)" || fail ".NET for $1 is not the one that is expected"
  "$(system_python)" -m zipfile -e build/dotnet/*"$tag".whl build/dotnet/unpacked
  chmod +x build/dotnet/unpacked/dotnetcore2/bin/dotnet*
  mv build/dotnet/unpacked/dotnetcore2/bin "$folder"
  rm -rf build/dotnet/unpacked build/dotnet/*.whl
}

# csharp_refuses FOLDER MESSAGE: what each way into a library says that cannot be used; the folder is where it is looked for.
csharp_refuses() {
  local said
  said=$(LD_LIBRARY_PATH=$1 mono build/csharp/Tests.exe) || fail "C# without a library: $said"
  [[ $(grep -c "$2" <<<"$said") == 3 ]] || fail "C# with the library of ${1:-nowhere} says: $said"
}

test_loading_in_csharp() {
  local folder=build/csharp/future
  mkdir -p "$folder"
  printf 'unsigned mimo_abi_version(void) { return 99; }\nconst char *mimo_version(void) { return "9.8.7"; }\n' |
    "${CC:-cc}" -shared -fPIC -x c - -o "$folder/libmimo.so"
  csharp_refuses '' 'libmimo was not found'
  csharp_refuses "$folder" 'libmimo 9.8.7 has ABI version 99, expected 1'
  printf 'unsigned mimo_abi_version(void) { return 1; }\nconst char *mimo_version(void) { return "1.0.0"; }\n' |
    "${CC:-cc}" -shared -fPIC -x c - -o "$folder/libmimo.so"
  csharp_refuses "$folder" 'libmimo 1.0.0 has no mimo_[a-z_]*, which'
  printf 'int other;\n' | "${CC:-cc}" -shared -fPIC -x c - -o "$folder/libmimo.so"
  csharp_refuses "$folder" 'has no mimo_abi_version'
}

# csharp_ends RUNNER...: programs end that leave everything alive.
csharp_ends() {
  local file=build/csharp/recorded.h5
  timeout 60 "$@" build/csharp/Tests.exe --end "$file" >/dev/null || fail "C# does not end ($1): $?"
  "$@" build/csharp/Tests.exe --ended "$file" >/dev/null || fail "C# leaves half a recording ($1)"
}

test_csharp() {
  build_program
  build_csharp
  echo "Tests of the C# classes"
  local -x LD_LIBRARY_PATH=$PWD/build/lib
  mono build/csharp/Tests.exe --all
  csharp_ends mono
  if [[ $(uname -sm) == "Linux x86_64" ]]; then
    fetch_dotnet linux
    build/dotnet/linux/dotnet exec --runtimeconfig tests/package/dotnet.json build/csharp/Tests.exe --all
    csharp_ends build/dotnet/linux/dotnet exec --runtimeconfig tests/package/dotnet.json
  fi
  test_loading_in_csharp
  mono build/csharp/Game.exe 1
  mono build/csharp/OwnGoal.exe
  follow csharp
}

# ---- MATLAB and Octave ------------------------------------------------------------------------------------

build_mex() {
  need "${octave_packages[@]}"
  local root=$PWD
  mkdir -p build/matlab
  (cd build/matlab && CFLAGS="-O2 -Wall -Wextra -Werror" \
    octave-cli --no-init-file --norc --no-history --path ../../bindings/matlab --eval "mimo_build('$root')")
}

octave_with_mimo() {
  octave-cli --no-init-file --norc --no-history --path "$PWD/bindings/matlab" --path "$PWD/bindings/matlab/tests" --path "$PWD/build/matlab" "$@"
}

# octave_says MESSAGE FOLDER CODE...: what Octave says that runs the code in a folder, with the functions on its path.
octave_says() {
  local message=$1 folder=$2 said
  shift 2
  said=$(cd "$folder" && CFLAGS=-O0 octave-cli --no-init-file --norc --no-history --path "$matlab" --eval "$*" 2>&1) || true
  [[ $said == *"$message"* ]] || fail "Octave says: $said"
}

# The gateway is compiled for a clone whose path is relative, and for a library that the compiler finds by itself; what
# is missing is named.
test_building_for_octave() {
  local -x matlab=$PWD/bindings/matlab
  local elsewhere=$PWD/build/octave clone=$PWD/build/octave/libmimo
  rm -rf "$elsewhere"
  mkdir -p "$clone/build/installed" "$elsewhere/no"
  ln -s "$PWD/build/lib" "$clone/build/lib"
  ln -s "$PWD/include" "$clone/include"
  octave_says 'mimo_build compiles it' "$elsewhere" 'mimo_version()'
  octave_says "libmimo is 'nowhere', which is no folder" "$elsewhere" "mimo_build('nowhere')"
  octave_says "run ./dev build in $elsewhere/no" "$elsewhere" "mimo_build('no')"
  octave_says 'good' "$elsewhere" "mimo_build('libmimo'); cd no; addpath('..'); mimo_version(), disp('good')"
  CPATH=$PWD/include LIBRARY_PATH=$PWD/build/lib LD_LIBRARY_PATH=$PWD/build/lib \
    octave_says 'good' "$clone/build/installed" "mimo_build(); mimo_version(), disp('good')"
}

test_octave() {
  grep -H '^#include "' bindings/matlab/*.[ch] | sed -E 's|^.*/(\w+)\.[ch]:#include "(\w+)\.h"|\1 \2|' | acyclic "the parts of the MEX gateway"
  build_program
  build_mex
  echo "Tests of the MEX gateway"
  octave_with_mimo --eval tests
  test_building_for_octave
  local example
  for example in examples/matlab/*.m; do octave_with_mimo "$example"; done
  follow matlab
}

# ---- The same in every language ---------------------------------------------------------------------------

# hashed LANGUAGE COMMAND...: runs a program that writes the blocks of each scene to a file of its name in a folder, and
# prints scenes and sums of rewards; puts the files' hashes in between.
hashed() {
  local folder=$PWD/build/same/$1 scene sum
  mkdir -p "$folder"
  shift
  "$@" "$folder" | while read -r scene sum; do
    echo "$scene $(build/bin/same_fnv1a "$folder/$scene") $sum"
    rm "$folder/$scene"
  done
}

same_in_octave() { octave_with_mimo --path "$PWD/tests/same" --eval "same('$1')"; }

same_in_python() {
  MIMO_LIBRARY=$PWD/build/lib/libmimo.so PYTHONPATH=bindings/python/src build/python-venv/bin/python tests/same/same.py "$1"
}

same_in_rust() {
  MIMO_LIB_DIR=$PWD/build/lib CARGO_TARGET_DIR=$PWD/build/rust \
    cargo run -q --manifest-path bindings/rust/mimo/Cargo.toml --example same
}

# The scenario of tests/capi/same.c: a line a scene, with the hash of all blocks.
test_same() {
  need "${rust_packages[@]}"
  build release mimo capi_same same_cpp same_fnv1a
  [[ -x build/python-venv/bin/python ]] || python_venv
  build_csharp
  build_mex
  local -x LD_LIBRARY_PATH=$PWD/build/lib
  local language
  echo "The same bytes in C, C++, Python, Rust, C# and Octave"
  mkdir -p build/same
  build/bin/capi_same | tee build/same/c.txt
  build/bin/same_cpp >build/same/cpp.txt
  hashed python same_in_python >build/same/python.txt
  same_in_rust >build/same/rust.txt
  mono build/csharp/Same.exe >build/same/csharp.txt
  hashed octave same_in_octave >build/same/octave.txt
  for language in cpp python rust csharp octave; do
    # MATLAB and Octave have no tasks of one's own.
    diff <(if [[ $language == octave ]]; then grep -v '^own ' build/same/c.txt; else cat build/same/c.txt; fi) "build/same/$language.txt" || fail "$language gives other bytes than C"
  done
}
