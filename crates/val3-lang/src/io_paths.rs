//! Paths of inputs and outputs as links name them: `BasicIO-1\%I0`.

/// Beginnings of the addresses of inputs.
const INPUTS: [&str; 3] = ["%I", "usrIn", "fIn"];

/// Whether the address at the end of a path is that of an input, which programs cannot write.
///
/// ```
/// use val3_lang::io_paths::is_input;
/// assert!(is_input(r"BasicIO-1\%I0") && is_input("usrIn1"));
/// assert!(!is_input(r"BasicIO-1\%Q0") && !is_input(r"Socket\host"));
/// ```
#[must_use]
pub fn is_input(path: &str) -> bool {
    let address = path.rsplit('\\').next().unwrap_or(path);
    INPUTS.iter().any(|start| address.starts_with(start))
}
