//! V0530: a circle of libraries or types.

use smol_str::SmolStr;

use crate::{diagnostic::Wording, rule::rule};

rule! {
    /// A project uses itself as a library or a user type, directly or through others.
    ///
    /// ## Why
    /// When the controller opens an application, it reads the interfaces of all libraries that it declares, and of
    /// their libraries. If library A uses library B, then B cannot use A: circles are not supported (6.6). The same
    /// holds for user types, whose values would contain themselves.
    ///
    /// ## Bad
    /// ```val3
    /// library part "Disk://part/part.pjx"
    /// putln("ready")
    ///
    /// --- part
    /// library tray "Disk://tray/tray.pjx"
    /// public num nWeight
    ///
    /// --- tray
    /// library part "Disk://part/part.pjx"
    /// public num nRows
    /// ```
    ///
    /// ## Good
    /// ```val3
    /// library part "Disk://part/part.pjx"
    /// library tray "Disk://tray/tray.pjx"
    /// putln("ready")
    ///
    /// --- part
    /// library tray "Disk://tray/tray.pjx"
    /// public num nWeight
    ///
    /// --- tray
    /// public num nRows
    /// ```
    V0530 "library-circle" Error
}

/// Returns the wording of the finding. The first project is repeated at the end of `chain`.
pub(crate) fn word(chain: &[SmolStr]) -> Wording {
    let names: Vec<String> = chain.iter().map(|name| format!("`{name}`")).collect();
    let message = match names.as_slice() {
        [only] | [only, _] => format!("the project {only} uses itself"),
        _ => format!("the projects use each other in a circle: {}", names.join(" -> ")),
    };
    Wording::new(message, "closes the circle", "move the shared parts into a project of their own, and use it in both")
}

#[cfg(test)]
mod tests {
    use expect_test::expect;

    use super::*;

    #[test]
    fn a_circle_of_two_libraries_is_reported() {
        expect![[r#"
            the projects use each other in a circle: `part` -> `tray` -> `part`
            | closes the circle
            ? move the shared parts into a project of their own, and use it in both
        "#]]
        .assert_eq(&word(&["part".into(), "tray".into(), "part".into()]).to_string());
    }

    #[test]
    fn a_project_that_names_itself_is_reported() {
        expect![[r#"
            the project `part` uses itself
            | closes the circle
            ? move the shared parts into a project of their own, and use it in both
        "#]]
        .assert_eq(&word(&["part".into(), "part".into()]).to_string());
    }
}
