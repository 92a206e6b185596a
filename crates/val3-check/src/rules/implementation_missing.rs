//! V0605: a library without an item of the interface.

use smol_str::SmolStr;
use val3_analysis::problem::NameKind;

use crate::{diagnostic::Wording, english::all_of, phrase::name_kind, rule::rule};

rule! {
    /// A library that is loaded under an identifier does not contain a program or data of the interface.
    ///
    /// ## Why
    /// The project that declares the identifier defines the interface. Any library with the same public programs and
    /// data may be loaded under it (6.3). If an item is missing, `libLoad` returns 11, and the first use of the item
    /// stops the task with run-time error 80 (6.6). `libExist` and `isDefined` report beforehand whether an item
    /// exists. A program that tests the code may be right, so this is a warning.
    ///
    /// ## Bad
    /// ```val3
    /// library part "Disk://partBox/partBox.pjx"
    /// if part:libLoad("Disk://partBag")==0
    ///   call part:pick(3)
    /// endIf
    ///
    /// --- partBox
    /// public program pick(num x_nCount)
    /// begin
    ///   putln(x_nCount)
    /// end
    ///
    /// --- partBag
    /// public num nWeight
    /// ```
    ///
    /// ## Good
    /// ```val3
    /// library part "Disk://partBox/partBox.pjx"
    /// if part:libLoad("Disk://partBag")==0
    ///   call part:pick(3)
    /// endIf
    ///
    /// --- partBox
    /// public program pick(num x_nCount)
    /// begin
    ///   putln(x_nCount)
    /// end
    ///
    /// --- partBag
    /// public program pick(num x_nCount)
    /// begin
    ///   putln(x_nCount*2)
    /// end
    /// ```
    V0605 "implementation-missing" Warning
}

/// Returns the wording of the finding; `items` are sorted by name.
pub(crate) fn word(alias: &str, library: &str, items: &[(NameKind, SmolStr)]) -> Wording {
    match items {
        [(what, item)] => one(alias, library, item, *what),
        _ => several(alias, library, items),
    }
}

fn one(alias: &str, library: &str, item: &str, what: NameKind) -> Wording {
    let brackets = if what == NameKind::Program { "()" } else { "" };
    let what = name_kind(what);
    Wording::new(
        format!("the library `{library}` does not contain the {what} `{item}` of the interface of `{alias}`"),
        format!("has no {what} `{item}`"),
        format!("add it as public to `{library}`, or test `{alias}:libExist(\"{item}{brackets}\")` before each use"),
    )
}

fn several(alias: &str, library: &str, items: &[(NameKind, SmolStr)]) -> Wording {
    let names: Vec<&str> = items.iter().map(|(_, item)| item.as_str()).collect();
    let count = items.len();
    Wording::new(
        format!(
            "the library `{library}` does not contain {count} items of the interface of `{alias}`: {}",
            all_of(&names)
        ),
        format!("has none of {count} items"),
        format!("load a library with the interface of `{alias}`, or add the items as public to `{library}`"),
    )
}

#[cfg(test)]
mod tests {
    use expect_test::expect;

    use super::*;

    #[test]
    fn a_missing_program_is_reported() {
        expect![[r#"
            the library `partBag` does not contain the program `pick` of the interface of `part`
            | has no program `pick`
            ? add it as public to `partBag`, or test `part:libExist("pick()")` before each use
        "#]]
        .assert_eq(&word("part", "partBag", &[(NameKind::Program, "pick".into())]).to_string());
    }

    #[test]
    fn missing_data_are_reported() {
        expect![[r#"
            the library `partBag` does not contain the data `nWeight` of the interface of `part`
            | has no data `nWeight`
            ? add it as public to `partBag`, or test `part:libExist("nWeight")` before each use
        "#]]
        .assert_eq(&word("part", "partBag", &[(NameKind::Data, "nWeight".into())]).to_string());
    }

    #[test]
    fn the_message_names_the_other_library() {
        let items = [(NameKind::Program, "grip".into()), (NameKind::Data, "nWeight".into())];
        expect![[r#"
            the library `io` does not contain 2 items of the interface of `part`: `grip` and `nWeight`
            | has none of 2 items
            ? load a library with the interface of `part`, or add the items as public to `io`
        "#]]
        .assert_eq(&word("part", "io", &items).to_string());
    }
}
