//! Copies the library to a folder where programs that cargo runs find it, and reports the folder to mimo-sys.
use std::path::PathBuf;
use std::{env, fs};

fn main() {
    let from = PathBuf::from(env::var_os("CARGO_MANIFEST_DIR").expect("cargo sets it")).join("libraries");
    let to = PathBuf::from(env::var_os("OUT_DIR").expect("cargo sets it"));
    for entry in fs::read_dir(from).expect("the crate has its libraries") {
        let file = entry.expect("a file").path();
        let name = file.file_name().expect("a name").to_string_lossy().into_owned();
        fs::copy(&file, to.join(&name)).expect("the build folder can be written");
        // Linkers look for the name without a number, programs for the one with.
        if name == "libmimo.so.1" {
            fs::copy(&file, to.join("libmimo.so")).expect("the build folder can be written");
        }
    }
    println!("cargo:rustc-link-search=native={}", to.display());
    println!("cargo:folder={}", to.display());
    println!("cargo:rerun-if-changed=libraries");
}
