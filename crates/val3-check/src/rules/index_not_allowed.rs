//! V0209: an index or key where none is allowed.

use crate::{diagnostic::Wording, english::container, rule::rule};

rule! {
    /// An index or key is used where none is allowed.
    ///
    /// ## Why
    /// An instruction or program that works on a whole container expects only its name; an index or key would select a
    /// single value. Only a one-dimensional array may have an index there, which sets the start of the part that is
    /// passed (2.6.3). After a single value an index has no meaning. In both cases the controller does not load the
    /// application.
    ///
    /// ## Bad
    /// ```val3
    /// num nCount
    /// string sLabel[""]
    ///
    /// nCount=size(sLabel["box"])
    /// ```
    ///
    /// ## Good
    /// ```val3
    /// num nCount
    /// string sLabel[""]
    ///
    /// nCount=size(sLabel)
    /// ```
    V0209 "index-not-allowed" Error
}

/// Returns the wording of the finding.
pub(crate) fn word(name: &str, ty: &str, callee: Option<&str>) -> Wording {
    let index = if ty.contains('"') { "key" } else { "index" };
    match callee {
        Some(callee) => Wording::new(
            format!("`{callee}` takes `{name}` as a whole, without {} {index}", article(index)),
            format!("`{name}` is {}", container(ty)),
            format!("write `{name}`"),
        ),
        None => Wording::new(
            format!("`{name}` is {} (`{ty}`) and takes no index", container(ty)),
            "no index is allowed here",
            String::new(),
        ),
    }
}

fn article(index: &str) -> &'static str {
    if index == "index" { "an" } else { "a" }
}

#[cfg(test)]
mod tests {
    use expect_test::expect;

    use super::word;

    #[test]
    fn an_index_of_a_whole_container_is_reported() {
        expect![[r#"
            `size` takes `sLabel` as a whole, without a key
            | `sLabel` is a collection
            ? write `sLabel`
        "#]]
        .assert_eq(&word("sLabel", "string[\"\"]", Some("size")).to_string());
        expect![[r#"
            `resize` takes `nGrid` as a whole, without an index
            | `nGrid` is a two-dimensional array
            ? write `nGrid`
        "#]]
        .assert_eq(&word("nGrid", "num[,]", Some("resize")).to_string());
    }

    #[test]
    fn an_index_of_a_single_value_is_reported() {
        expect![[r#"
            `x_nValue` is a single value (`num`) and takes no index
            | no index is allowed here
        "#]]
        .assert_eq(&word("x_nValue", "num", None).to_string());
    }
}
