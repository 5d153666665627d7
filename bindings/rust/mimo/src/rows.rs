//! Rows of a fixed length in a flat slice.

/// The i-th row.
pub(crate) fn row<const N: usize>(values: &[f64], i: usize) -> [f64; N] {
    let mut row = [0.0; N];
    row.copy_from_slice(&values[N * i..N * (i + 1)]);
    row
}
