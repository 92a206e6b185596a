//! V0508: a program whose name differs from its file.

use crate::{
    diagnostic::{Fix, Wording},
    fix::{Site, rename},
    rule::rule,
};

rule! {
    /// The program in a `.pgx` file has another name than the file.
    ///
    /// ## Why
    /// A project lists its programs by file name, and code calls them by program name. If they differ, a line calls
    /// another program than the one that the project loads. The comparison ignores letter case and folders before the
    /// file name.
    ///
    /// ## Bad
    /// ```val3
    /// putln("ready")
    ///
    /// === main/place.pgx
    /// <?xml version="1.0" encoding="utf-8"?>
    /// <Programs xmlns="http://www.staubli.com/robotics/VAL3/Program/2">
    ///   <Program name="plcae">
    ///     <Code><![CDATA[begin
    ///   putln("placed")
    /// end]]></Code>
    ///   </Program>
    /// </Programs>
    /// ```
    ///
    /// ## Good
    /// ```val3
    /// putln("ready")
    ///
    /// === main/place.pgx
    /// <?xml version="1.0" encoding="utf-8"?>
    /// <Programs xmlns="http://www.staubli.com/robotics/VAL3/Program/2">
    ///   <Program name="place">
    ///     <Code><![CDATA[begin
    ///   putln("placed")
    /// end]]></Code>
    ///   </Program>
    /// </Programs>
    /// ```
    V0508 "program-name-mismatch" Warning
}

/// Returns the wording of the finding.
pub(crate) fn word(program: &str, file: &str) -> Wording {
    Wording::new(
        format!("the program is called `{program}`, but its file is `{file}.pgx`"),
        format!("the file is `{file}.pgx`"),
        format!("call the program `{file}`, or the file `{program}.pgx`"),
    )
}

/// Renames the program to its file's name.
pub(crate) fn fix(site: &Site<'_>, program: &str, file: &str) -> Option<Fix> {
    rename(site, program, Some(file))
}

#[cfg(test)]
mod tests {
    use expect_test::expect;

    use super::*;

    #[test]
    fn both_names_are_shown() {
        expect![[r#"
            the program is called `plcae`, but its file is `place.pgx`
            | the file is `place.pgx`
            ? call the program `place`, or the file `plcae.pgx`
        "#]]
        .assert_eq(&word("plcae", "place").to_string());
    }
}
