//! The C interface of libmimo as it stands in `mimo.h`: functions, structs and constants, with its comments.
//! The crate `mimo` makes a safe interface of it; use that unless you need what it does not have.
//!
//! The library is found by `MIMO_LIB_DIR` (the folder of `libmimo.so`), else by pkg-config; with the feature `bundled` it is
//! built from the sources around this crate. The system has to find it again when the program runs: installed, or by
//! `LD_LIBRARY_PATH`; cargo does that for programs that it runs itself.
// Compilers before the documentation lints of newer ones do not know their names; this has to come first.
#![allow(unknown_lints)]
#![allow(non_camel_case_types)]
#![allow(clippy::doc_lazy_continuation, clippy::doc_overindented_list_items, clippy::too_many_arguments)]
#![allow(rustdoc::broken_intra_doc_links, rustdoc::invalid_html_tags)]
#![warn(missing_docs)]

include!("bindings.rs");
