//! V0537: a namespace that does not belong to the file.

use crate::{
    diagnostic::{Fix, Wording},
    fix::Site,
    rule::rule,
};

rule! {
    /// The namespace of a file does not match its kind.
    ///
    /// ## Why
    /// The namespace identifies the kind of a file and the version of its format. Every controller of s7 and s8 writes
    /// `Project/3`, `Program/2`, `Param/1` and `Data/2`, and those of s5 and s6 write `ProjectNameSpace`,
    /// `ProgramNameSpace` and `DataNameSpace`. The controller does not recognise elements in another namespace and does
    /// not load the application.
    ///
    /// ## Bad
    /// ```val3
    /// putln("ready")
    ///
    /// === main/main.dtx
    /// <?xml version="1.0" encoding="utf-8"?>
    /// <Database xmlns="http://www.staubli.com/robotics/VAL3/Data/3">
    ///   <Datas>
    ///   </Datas>
    /// </Database>
    /// ```
    ///
    /// ## Good
    /// ```val3
    /// putln("ready")
    ///
    /// === main/main.dtx
    /// <?xml version="1.0" encoding="utf-8"?>
    /// <Database xmlns="http://www.staubli.com/robotics/VAL3/Data/2">
    ///   <Datas>
    ///   </Datas>
    /// </Database>
    /// ```
    V0537 "namespace" Error
}

/// Returns the wording of the finding.
pub(crate) fn word(element: &str, found: &str, expected: &str) -> Wording {
    Wording::new(
        format!("the namespace of `{element}` is `{expected}`, not `{found}`"),
        "another namespace",
        "the content must have the format of this namespace: check the tool that wrote the file",
    )
}

/// Writes the namespace of the file.
pub(crate) fn fix(site: &Site<'_>, expected: &str) -> Option<Fix> {
    Some(Fix::guess(format!("write `{expected}`"), vec![site.replace(site.range, expected)]))
}

#[cfg(test)]
mod tests {
    use expect_test::expect;

    use super::*;

    #[test]
    fn another_namespace_is_reported() {
        expect![[r#"
            the namespace of `Database` is `…/Data/2`, not `…/Data/3`
            | another namespace
            ? the content must have the format of this namespace: check the tool that wrote the file
        "#]]
        .assert_eq(&word("Database", "…/Data/3", "…/Data/2").to_string());
    }
}
