//! Finds libmimo: in the folder MIMO_LIB_DIR, else where pkg-config says. With the feature `bundled` it is built from
//! the sources around this crate instead.
use std::path::{Path, PathBuf};
use std::{env, process::Command};

fn main() {
    println!("cargo:rerun-if-env-changed=MIMO_LIB_DIR");
    println!("cargo:rerun-if-env-changed=PKG_CONFIG_PATH");
    // docs.rs has no libmimo, and documentation needs none.
    if env::var_os("DOCS_RS").is_some() {
        return;
    }
    let folder = if env::var_os("CARGO_FEATURE_BUNDLED").is_some() {
        build()
    } else {
        env::var_os("MIMO_LIB_DIR").map(PathBuf::from).or_else(ask_pkg_config).expect(
            "libmimo was not found: install it so that `pkg-config --libs mimo` works, set MIMO_LIB_DIR to the folder of \
             libmimo.so, or ask for the feature `bundled`",
        )
    };
    if folder != Path::new("") {
        println!("cargo:rustc-link-search=native={}", folder.display());
    }
    println!("cargo:rustc-link-lib=dylib=mimo");
}

/// The folder of the installed library; empty when it is one that the linker searches anyway.
fn ask_pkg_config() -> Option<PathBuf> {
    let output = Command::new("pkg-config").args(["--libs-only-L", "mimo"]).output().ok()?;
    if !output.status.success() {
        return None;
    }
    let text = String::from_utf8(output.stdout).ok()?;
    Some(text.trim().trim_start_matches("-L").into())
}

/// Builds the library, and nothing else; MIMO_CMAKE_ARGS has further arguments for CMake, such as -Dmujoco_ROOT=FOLDER.
/// Programs that cargo runs find it; for others it has to be installed.
fn build() -> PathBuf {
    let sources = Path::new(env!("CARGO_MANIFEST_DIR"))
        .join("../../..")
        .canonicalize()
        .expect("the sources of libmimo");
    let out = PathBuf::from(env::var_os("OUT_DIR").expect("cargo sets OUT_DIR")).join("libmimo");
    for part in ["CMakeLists.txt", "cmake", "include", "models", "src"] {
        println!("cargo:rerun-if-changed={}", sources.join(part).display());
    }
    let further = env::var("MIMO_CMAKE_ARGS").unwrap_or_default();
    println!("cargo:rerun-if-env-changed=MIMO_CMAKE_ARGS");
    run(Command::new("cmake")
        .arg("-S")
        .arg(&sources)
        .arg("-B")
        .arg(&out)
        .args(["-DCMAKE_BUILD_TYPE=Release", "-DMIMO_TESTS=OFF", "-DMIMO_PROGRAM=OFF"])
        .args(further.split_whitespace()));
    let jobs = env::var("NUM_JOBS").unwrap_or_else(|_| "1".into());
    run(Command::new("cmake").arg("--build").arg(&out).args(["--target", "mimo", "--parallel", &jobs]));
    out.join("lib")
}

fn run(command: &mut Command) {
    match command.status() {
        Ok(status) if status.success() => {}
        Ok(status) => panic!("{:?} failed: {}", command, status),
        Err(error) => panic!("{:?} cannot be run: {}", command, error),
    }
}
