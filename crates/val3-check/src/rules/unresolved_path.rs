//! V0608: a path to a library that cannot be resolved.

use val3_analysis::problem::FileRole;
use val3_syntax::{TextRange, TextSize};

use crate::{
    diagnostic::{Fix, Wording},
    fix::Site,
    phrase::{did_you_mean_or, file_role},
    rule::rule,
};

rule! {
    /// The path of a library or user type starts with a root without a configured folder.
    ///
    /// ## Why
    /// A library that is not found cannot be checked, so every call and every name with its identifier is accepted.
    /// This is reported once, at the path.
    ///
    /// - A root that resembles one of the controller's (`Disc` for `Disk`) is probably a misspelling: a warning.
    /// - Any other root may be a medium (`USB0`) or the name of a connection: information. The setting `roots` of
    ///   `val3.toml` names the folder with its content.
    /// - `Disk`, which is also the root of a path without one, means the folder `usrapp`. If the project is not in such
    ///   a folder and the path cannot be found from the folders above, the library is not part of the checked files:
    ///   information. The setting `disk` of `val3.toml` names the folder.
    ///
    /// ## Bad
    /// ```val3
    /// library part "Disc://part/part.pjx"
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
    V0608 "unresolved-path" Warning
}

/// Returns the wording of the finding.
pub(crate) fn word(what: FileRole, path: &str, root: &str, near: Option<&str>) -> Wording {
    let is_disk = root.eq_ignore_ascii_case("Disk");
    let why = if is_disk && near.is_none() {
        format!("the {} `{path}` is not among the checked files", file_role(what))
    } else {
        format!("the {} `{path}` cannot be found: no folder is configured for `{root}://`", file_role(what))
    };
    let advice = if is_disk {
        "check the whole folder `usrapp`, or name it with `disk` in `val3.toml`".to_owned()
    } else {
        format!("name the folder of `{root}` with `roots` in `val3.toml`")
    };
    Wording::new(why, "uses of it are not checked", did_you_mean_or(near, &advice))
}

/// Writes the root that was probably intended.
pub(crate) fn fix(site: &Site<'_>, root: &str, near: Option<&str>) -> Option<Fix> {
    let near = near?;
    let at = site.text().find(root)?;
    let start = site.range.start() + TextSize::try_from(at).ok()?;
    Some(Fix::guess(format!("write `{near}`"), vec![site.replace(TextRange::at(start, TextSize::of(root)), near)]))
}

#[cfg(test)]
mod tests {
    use expect_test::expect;

    use super::*;

    #[test]
    fn a_misspelt_root_is_reported() {
        expect![[r#"
            the library `Disc://part` cannot be found: no folder is configured for `Disc://`
            | uses of it are not checked
            ? did you mean `Disk`?
        "#]]
        .assert_eq(&word(FileRole::Library, "Disc://part", "Disc", Some("Disk")).to_string());
    }

    #[test]
    fn a_path_on_disk_without_usrapp_is_reported() {
        expect![[r#"
            the user type `Slot` is not among the checked files
            | uses of it are not checked
            ? check the whole folder `usrapp`, or name it with `disk` in `val3.toml`
        "#]]
        .assert_eq(&word(FileRole::Type, "Slot", "Disk", None).to_string());
    }

    #[test]
    fn a_path_on_another_medium_is_reported() {
        expect![[r#"
            the library `USB0://part` cannot be found: no folder is configured for `USB0://`
            | uses of it are not checked
            ? name the folder of `USB0` with `roots` in `val3.toml`
        "#]]
        .assert_eq(&word(FileRole::Library, "USB0://part", "USB0", None).to_string());
    }
}
