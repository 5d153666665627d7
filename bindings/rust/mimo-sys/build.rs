//! Finds libmimo: in the folder MIMO_LIB_DIR, otherwise by pkg-config. With the feature `bundled` the library
//! comes from the crate `mimo-native-*` of the target or, in a clone of the repository, is built from its
//! sources. If there is no library, one line says so, and what to do.
use std::path::{Path, PathBuf};
use std::{env, process::Command};

fn main() {
    for name in ["MIMO_LIB_DIR", "PKG_CONFIG_PATH", "PKG_CONFIG_LIBDIR"] {
        println!("cargo:rerun-if-env-changed={}", name);
    }
    // docs.rs has no libmimo, and documentation needs none.
    if env::var_os("DOCS_RS").is_some() {
        return;
    }
    let folder = if env::var_os("CARGO_FEATURE_BUNDLED").is_some() {
        brought().unwrap_or_else(build)
    } else if let Some(folder) = env::var_os("MIMO_LIB_DIR") {
        named(folder.into())
    } else {
        ask_pkg_config()
    };
    if folder != Path::new("") {
        println!("cargo:rustc-link-search=native={}", folder.display());
    }
    println!("cargo:rustc-link-lib=dylib=mimo");
}

fn fail(message: &str) -> ! {
    eprintln!("\n{}\n", message);
    std::process::exit(1)
}

/// The folder of the library in a crate `mimo-native-*`. The packages that ./dev makes depend on these
/// crates.
fn brought() -> Option<PathBuf> {
    let of_native = |name: &std::ffi::OsStr| name.to_string_lossy().starts_with("DEP_MIMO_NATIVE_");
    env::vars_os().find(|(name, _)| of_native(name)).map(|(_, folder)| folder.into())
}

/// The folder that the user names. It is not on the search path of programs that start.
fn named(folder: PathBuf) -> PathBuf {
    let library = folder.join("libmimo.so");
    if !folder.is_absolute() || !library.exists() {
        fail(&format!(
            "MIMO_LIB_DIR is \"{}\", expected the absolute path of a folder with libmimo.so",
            folder.display()
        ));
    }
    println!("cargo:rerun-if-env-changed=LD_LIBRARY_PATH");
    let searched = env::var_os("LD_LIBRARY_PATH").unwrap_or_default();
    if !env::split_paths(&searched).any(|one| one.canonicalize().ok() == folder.canonicalize().ok()) {
        println!("cargo:warning=programs will find libmimo.so with LD_LIBRARY_PATH={}", folder.display());
    }
    folder
}

/// The folder of the installed library; empty if the linker searches it anyway.
fn ask_pkg_config() -> PathBuf {
    let not_found = |why: &str| -> ! {
        fail(&format!(
            "libmimo was not found ({}). Install it (cmake --install build), or set MIMO_LIB_DIR to the folder of libmimo.so, \
             or, in a clone of its repository, use the feature `bundled`",
            why
        ))
    };
    match Command::new("pkg-config").args(["--libs-only-L", "mimo"]).output() {
        Err(error) => not_found(&format!("pkg-config: {}", error)),
        Ok(output) if !output.status.success() => not_found("pkg-config does not know \"mimo\""),
        Ok(output) => String::from_utf8_lossy(&output.stdout).trim().trim_start_matches("-L").into(),
    }
}

/// Builds the library alone. MIMO_CMAKE_ARGS has further arguments for CMake, such as -Dmujoco_ROOT=FOLDER;
/// MIMO_BUILD_DIR is the build folder, by default one of cargo's. Programs that cargo runs find the library;
/// for other programs it has to be installed.
fn build() -> PathBuf {
    let sources = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../..");
    if !sources.join("include/mimo/mimo.h").exists() {
        fail("the feature `bundled` has no libmimo for this target; install libmimo, and set MIMO_LIB_DIR to its folder");
    }
    let sources = sources.canonicalize().expect("the sources exist");
    let own = PathBuf::from(env::var_os("OUT_DIR").expect("cargo sets OUT_DIR")).join("libmimo");
    let out = env::var_os("MIMO_BUILD_DIR").map_or(own.clone(), PathBuf::from);
    for part in ["CMakeLists.txt", "cmake", "include", "models", "src"] {
        println!("cargo:rerun-if-changed={}", sources.join(part).display());
    }
    let further = env::var("MIMO_CMAKE_ARGS").unwrap_or_default();
    for name in ["MIMO_CMAKE_ARGS", "MIMO_BUILD_DIR"] {
        println!("cargo:rerun-if-env-changed={}", name);
    }
    run(Command::new("cmake")
        .arg("-S")
        .arg(&sources)
        .arg("-B")
        .arg(&out)
        .args(["-DCMAKE_BUILD_TYPE=Release", "-DMIMO_TESTS=OFF", "-DMIMO_PROGRAM=OFF"])
        .args(further.split_whitespace()));
    let jobs = env::var("NUM_JOBS").unwrap_or_else(|_| "1".into());
    run(Command::new("cmake").arg("--build").arg(&out).args(["--target", "mimo", "--parallel", &jobs]));
    if out != own {
        bring(&out.join("lib"), &own.join("lib"));
    }
    own.join("lib")
}

/// Cargo searches libraries of the programs that it runs in its own folders only.
fn bring(from: &Path, to: &Path) {
    std::fs::create_dir_all(to).expect("cargo's folder can be written");
    for entry in std::fs::read_dir(from).expect("the library was built there") {
        let file = entry.expect("a file").path();
        std::fs::copy(&file, to.join(file.file_name().expect("a name")))
            .expect("cargo's folder can be written");
    }
}

fn run(command: &mut Command) {
    match command.status() {
        Ok(status) if status.success() => {}
        Ok(status) => fail(&format!("{:?} failed: {}", command, status)),
        Err(error) => fail(&format!("{:?} cannot be run: {}", command, error)),
    }
}
