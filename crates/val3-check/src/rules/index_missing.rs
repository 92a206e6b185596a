//! V0208: an array of several dimensions, or a collection, without its index or key.

use crate::{diagnostic::Wording, english::container, rule::rule};

rule! {
    /// An array with several dimensions, or a collection, is used without its index or key.
    ///
    /// ## Why
    /// The name of a one-dimensional array may be used without an index: it then means the element with index 0
    /// (2.5.3). An array of two or three dimensions needs its indexes, and a collection its key. Without them the
    /// controller does not load the application.
    ///
    /// ## Bad
    /// ```val3
    /// num nGrid[3,4]
    ///
    /// nGrid=1
    /// ```
    ///
    /// ## Good
    /// ```val3
    /// num nGrid[3,4]
    ///
    /// nGrid[0,0]=1
    /// ```
    V0208 "index-missing" Error
}

/// Returns the wording of the finding.
pub(crate) fn word(name: &str, ty: &str) -> Wording {
    let container = container(ty);
    let (needs, brackets) = match ty.chars().filter(|&sign| sign == ',').count() {
        _ if ty.contains('"') => ("a key", "[\"…\"]"),
        0 => ("an index", "[…]"),
        1 => ("two indexes", "[…,…]"),
        _ => ("three indexes", "[…,…,…]"),
    };
    Wording::new(
        format!("`{name}` is {container} (`{ty}`) and needs {needs} here"),
        format!("{needs} missing").replacen("an ", "", 1).replacen("a ", "", 1),
        format!("write `{name}{brackets}`"),
    )
}

#[cfg(test)]
mod tests {
    use expect_test::expect;

    use super::word;

    #[test]
    fn the_message_says_what_is_wrong() {
        expect![[r#"
            `nGrid` is a two-dimensional array (`num[,]`) and needs two indexes here
            | two indexes missing
            ? write `nGrid[…,…]`
        "#]]
        .assert_eq(&word("nGrid", "num[,]").to_string());
        expect![[r#"
            `nCube` is a three-dimensional array (`num[,,]`) and needs three indexes here
            | three indexes missing
            ? write `nCube[…,…,…]`
        "#]]
        .assert_eq(&word("nCube", "num[,,]").to_string());
        expect![[r#"
            `dIn` is a collection (`dio[""]`) and needs a key here
            | key missing
            ? write `dIn["…"]`
        "#]]
        .assert_eq(&word("dIn", "dio[\"\"]").to_string());
    }
}
