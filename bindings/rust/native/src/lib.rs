//! libmimo for one system, for the crate `mimo-sys`. This crate declares nothing.
