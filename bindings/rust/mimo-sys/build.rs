//! Finds libmimo: in the folder MIMO_LIB_DIR, else where pkg-config says.
use std::{env, process::Command};

fn main() {
    println!("cargo:rerun-if-env-changed=MIMO_LIB_DIR");
    println!("cargo:rerun-if-env-changed=PKG_CONFIG_PATH");
    // docs.rs has no libmimo, and documentation needs none.
    if env::var_os("DOCS_RS").is_some() {
        return;
    }
    if let Some(folder) = env::var_os("MIMO_LIB_DIR").or_else(ask_pkg_config) {
        let folder = folder.to_string_lossy();
        if !folder.is_empty() {
            println!("cargo:rustc-link-search=native={}", folder);
        }
    } else {
        panic!("libmimo was not found: install it so that `pkg-config --libs mimo` works, or set MIMO_LIB_DIR to the folder of libmimo.so");
    }
    println!("cargo:rustc-link-lib=dylib=mimo");
}

/// The folder of the installed library; empty when it is one that the linker searches anyway.
fn ask_pkg_config() -> Option<std::ffi::OsString> {
    let output = Command::new("pkg-config").args(["--libs-only-L", "mimo"]).output().ok()?;
    if !output.status.success() {
        return None;
    }
    let text = String::from_utf8(output.stdout).ok()?;
    Some(text.trim().trim_start_matches("-L").into())
}
