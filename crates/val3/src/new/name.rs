//! Name validation for new applications.

use val3_lang::keywords::{is_identifier, reserved};
use val3_lang::test_names::is_test_application;
use val3_lang::versions::Version;
use val3_suite::library;

use super::files::TEST_NAMES;
use crate::user_error::UserError;

/// Maximum length of a name if VAL 3 has no limit, so that paths stay below the 260 characters of Windows.
const LONGEST: usize = 64;

/// Device names, which Windows permits for no file or folder; a digit follows COM and LPT.
const DEVICES: [&str; 6] = ["con", "prn", "aux", "nul", "com", "lpt"];

/// Checks that the name is valid for an application of this version.
///
/// # Errors
/// The name is no valid folder name or library alias.
pub(super) fn check(name: &str, version: Version) -> Result<(), UserError> {
    let longest = version.identifier_limit().unwrap_or(LONGEST);
    let reason = if !is_identifier(name) {
        "a name has letters, digits and `_`, and does not begin with a digit".to_owned()
    } else if name.len() > longest {
        format!("it has {} characters, and a name for {version} has at most {longest}", name.len())
    } else if reserved(name).is_some() {
        "it is a word of VAL 3".to_owned()
    } else if is_device(name) {
        "Windows reserves it for a device".to_owned()
    } else if is_test_application(name) {
        "names that end in `Test` are those of applications with tests".to_owned()
    } else if name == library::NAME || TEST_NAMES.contains(&name) {
        "the test of the application has the name".to_owned()
    } else {
        return Ok(());
    };
    Err(UserError::new(format!("an application cannot have the name `{name}`: {reason}"))
        .with_help("write a name such as `pickParts`"))
}

/// Whether Windows reserves the name, in upper or lower case.
fn is_device(name: &str) -> bool {
    let name = name.to_ascii_lowercase();
    let stem = name.trim_end_matches(|last: char| last.is_ascii_digit());
    let is_numbered = name.len() == stem.len() + 1;
    DEVICES.contains(&stem) && (["com", "lpt"].contains(&stem) == is_numbered) && name.len() <= stem.len() + 1
}

#[cfg(test)]
mod tests {
    use expect_test::expect;

    use super::*;

    const S7: Version = Version::new(7, 11, 0);
    const S8: Version = Version::new(8, 13, 0);

    #[test]
    fn names_are_identifiers_and_folders() {
        for name in ["pickParts", "_a", "com", "com10", "console", "Testing", "a23456789012345"] {
            assert_eq!(check(name, S7), Ok(()), "{name}");
        }
        assert_eq!(check("pickPartsFromTheBelt", S8), Ok(()));
    }

    #[test]
    fn other_names_are_refused_with_the_reason() {
        let long = "a".repeat(65);
        let names = ["", "1a", "a-b", "../a", "é", "movej", "endIf", "NUL", "com1", "aTest", "start", "val3assert"];
        let mut refused: Vec<String> = names.iter().map(|name| check(name, S7).unwrap_err().to_string()).collect();
        refused.push(check("pickPartsFromTheBelt", S7).unwrap_err().to_string());
        refused.push(check(&long, S8).unwrap_err().to_string());
        let reasons: Vec<&str> =
            refused.iter().filter_map(|text| text.lines().next()?.split_once("name ")).map(|(_, rest)| rest).collect();
        expect![[r#"
            ``: a name has letters, digits and `_`, and does not begin with a digit
            `1a`: a name has letters, digits and `_`, and does not begin with a digit
            `a-b`: a name has letters, digits and `_`, and does not begin with a digit
            `../a`: a name has letters, digits and `_`, and does not begin with a digit
            `é`: a name has letters, digits and `_`, and does not begin with a digit
            `movej`: it is a word of VAL 3
            `endIf`: it is a word of VAL 3
            `NUL`: Windows reserves it for a device
            `com1`: Windows reserves it for a device
            `aTest`: names that end in `Test` are those of applications with tests
            `start`: the test of the application has the name
            `val3assert`: the test of the application has the name
            `pickPartsFromTheBelt`: it has 20 characters, and a name for s7.11 has at most 15
            `aaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaa`: it has 65 characters, and a name for s8.13 has at most 64"#]].assert_eq(&reasons.join("\n"));
    }
}
