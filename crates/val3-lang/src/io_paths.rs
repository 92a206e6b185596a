//! Link paths of inputs and outputs: `BasicIO-1\%I0`.

/// Prefixes of input addresses.
const INPUTS: [&str; 3] = ["%I", "usrIn", "fIn"];

/// Whether the address at the end of a path is an input, which programs cannot write.
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

/// Prefixes of output addresses.
const OUTPUTS: [&str; 4] = ["%Q", "usrOut", "fOut", "valve"];

/// Whether the address at the end of a path is certainly an output. Other addresses may be either, such as the words of
/// a Modbus server.
///
/// ```
/// use val3_lang::io_paths::is_output;
/// assert!(is_output(r"BasicIO-1\%Q0") && is_output("valve1"));
/// assert!(!is_output(r"BasicIO-1\%I0") && !is_output(r"ModbusSrv-0\Modbus-Word\Vacuum"));
/// ```
#[must_use]
pub fn is_output(path: &str) -> bool {
    let address = path.rsplit('\\').next().unwrap_or(path);
    OUTPUTS.iter().any(|start| address.starts_with(start))
}

/// Prefixes of CS8 paths and their CS9 equivalents; `None` for boards that a CS9 does not have.
const OF_CS8: [(&str, Option<&str>); 9] = [
    ("usrIn", Some(r"UserIO\usrIn")),
    ("usrOut", Some(r"UserIO\usrOut")),
    ("fIn", Some(r"FastIO\fIn")),
    ("fOut", Some(r"FastIO\fOut")),
    ("valve", Some(r"ValveIO\valve")),
    ("BasicIO-", None),
    ("ModuleIO", None),
    ("Can-", None),
    ("ApplicomIO-", None),
];

/// CS9 path of a CS8 input or output: `None` if the link is no CS8 path, `Some(None)` if a CS9 has no equivalent.
///
/// ```
/// use val3_lang::io_paths::cs9_path;
/// assert_eq!(cs9_path("fIn0"), Some(Some(r"FastIO\fIn0".to_owned())));
/// assert_eq!(cs9_path(r"BasicIO-1\%I0"), Some(None));
/// assert_eq!(cs9_path(r"Socket\host"), None);
/// ```
#[must_use]
pub fn cs9_path(link: &str) -> Option<Option<String>> {
    let (start, other) = OF_CS8.iter().find(|(start, _)| link.starts_with(start))?;
    let rest = link.get(start.len()..).unwrap_or("");
    Some(other.map(|other| format!("{other}{rest}")))
}
