//! libmimo for one system, for the crate `mimo-sys`; nothing is declared here.
