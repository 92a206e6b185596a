//! V0538: a path with backslashes.

use crate::{
    diagnostic::{Fix, Wording},
    fix::Site,
    rule::rule,
};

rule! {
    /// A path in the project file is written with backslashes.
    ///
    /// ## Why
    /// The controller separates the parts of a path with `/`, as in `Disk://part/part.pjx`. A path with backslashes may
    /// work on the computer where it was written but not on the controller.
    ///
    /// ## Bad
    /// ```val3
    /// library part "Disk://part\part.pjx"
    /// call part:init()
    ///
    /// --- part
    /// public program init()
    /// begin
    ///   putln("part")
    /// end
    /// ```
    ///
    /// ## Good
    /// ```val3
    /// library part "Disk://part/part.pjx"
    /// call part:init()
    ///
    /// --- part
    /// public program init()
    /// begin
    ///   putln("part")
    /// end
    /// ```
    V0538 "path-separator" Warning
}

/// Returns the wording of the finding.
pub(crate) fn word(path: &str) -> Wording {
    Wording::new(
        format!("the path `{path}` is written with `\\`"),
        "not a separator of the controller",
        format!("write `{}`", with_slashes(path)),
    )
}

/// Writes the separators of the controller.
pub(crate) fn fix(site: &Site<'_>, path: &str) -> Option<Fix> {
    let path = with_slashes(path);
    Some(Fix::safe(format!("write `{path}`"), vec![site.replace(site.range, &path)]))
}

/// Returns `Disk://part/part.pjx` for `Disk:\\part\part.pjx`, and `Disk://part` for `Disk:\part`.
fn with_slashes(path: &str) -> String {
    let path = path.replace('\\', "/");
    match path.split_once(":/") {
        Some((root, rest)) => format!("{root}://{}", rest.trim_start_matches('/')),
        None => path,
    }
}

#[cfg(test)]
mod tests {
    use expect_test::expect;

    use super::*;

    #[test]
    fn the_message_says_what_is_wrong() {
        expect![[r#"
            the path `Disk:\part\part.pjx` is written with `\`
            | not a separator of the controller
            ? write `Disk://part/part.pjx`
        "#]]
        .assert_eq(&word("Disk:\\part\\part.pjx").to_string());
        assert_eq!(with_slashes(".\\tray\\tray.pjx"), "./tray/tray.pjx");
        assert_eq!(with_slashes("Disk:\\\\part\\part.pjx"), "Disk://part/part.pjx");
    }
}
