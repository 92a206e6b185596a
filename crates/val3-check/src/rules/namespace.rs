//! V0537: a namespace that is not that of the file.

use crate::{
    diagnostic::{Fix, Wording},
    fix::Site,
    rule::rule,
};

rule! {
    /// A file declares another namespace than the one of its kind.
    ///
    /// ## Why
    /// The namespace says what a file is and in which version of the format it is written. Every controller of s7 and
    /// s8 writes `Project/3`, `Program/2`, `Param/1` and `Data/2`, and those of s5 and s6 write `ProjectNameSpace`,
    /// `ProgramNameSpace` and `DataNameSpace`. Elements in another namespace are other elements to the controller,
    /// which does not load the application.
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

/// Words the finding.
pub(crate) fn word(element: &str, found: &str, expected: &str) -> Wording {
    Wording::new(
        format!("the namespace of `{element}` is `{expected}`, not `{found}`"),
        "another namespace",
        "the content has to be in the form that the namespace stands for: see what wrote the file",
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
    fn another_version() {
        expect![[r#"
            the namespace of `Database` is `…/Data/2`, not `…/Data/3`
            | another namespace
            ? the content has to be in the form that the namespace stands for: see what wrote the file
        "#]]
        .assert_eq(&word("Database", "…/Data/3", "…/Data/2").to_string());
    }
}
