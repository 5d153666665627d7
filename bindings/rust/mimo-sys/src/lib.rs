//! The C interface of libmimo as declared in `mimo.h`: functions, structs and constants, with its comments.
//! The crate `mimo` is the safe interface; use it unless you need something that it lacks.
//!
//! The build finds the library by `MIMO_LIB_DIR` (the folder of `libmimo.so`), otherwise by pkg-config; with
//! the feature `bundled` it builds the library from the sources in the repository. When a program starts, the
//! system has to find the library again: installed, or by `LD_LIBRARY_PATH`. Cargo takes care of this for
//! programs that it runs.
// Compilers before the documentation lints of newer ones do not know their names; this has to come first.
#![allow(unknown_lints)]
#![allow(non_camel_case_types)]
#![allow(clippy::doc_lazy_continuation, clippy::doc_overindented_list_items, clippy::too_many_arguments)]
#![allow(rustdoc::broken_intra_doc_links, rustdoc::invalid_html_tags)]
#![warn(missing_docs)]

include!("bindings.rs");
