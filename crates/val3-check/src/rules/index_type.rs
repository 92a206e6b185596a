//! V0211: an index that is not a `num`, or a key that is not a `string`.

use crate::{conversion, diagnostic::Wording, english::a, rule::rule};

rule! {
    /// The index of an array is not a `num`, or the key of a collection is not a `string`.
    ///
    /// ## Why
    /// The elements of an array are numbered from 0; an index with a fraction is rounded to the nearest whole number
    /// (2.5.3). The values of a collection have text keys: `"1"` is a key, `1` is not. The controller does not load an
    /// application that confuses them.
    ///
    /// ## Bad
    /// ```val3
    /// num nWeight[""]
    ///
    /// nWeight[1]=0.5
    /// ```
    ///
    /// ## Good
    /// ```val3
    /// num nWeight[""]
    ///
    /// nWeight["1"]=0.5
    /// ```
    V0211 "index-type" Error
}

/// Returns the wording of the finding.
pub(crate) fn word(name: &str, expected: &str, found: &str) -> Wording {
    let (container, place) = match expected {
        "string" => ("a collection", "key"),
        _ => ("an array", "index"),
    };
    Wording::new(
        format!("`{name}` is {container}: its {place} is {}, not {}", a(expected), a(found)),
        format!("this is {}", a(found)),
        conversion::advice(found, expected),
    )
}

#[cfg(test)]
mod tests {
    use expect_test::expect;

    use super::word;

    #[test]
    fn the_message_says_what_is_wrong() {
        expect![[r#"
            `nWeight` is a collection: its key is a `string`, not a `num`
            | this is a `num`
            ? `toString("", …)` turns a number into text
        "#]]
        .assert_eq(&word("nWeight", "string", "num").to_string());
        expect![[r#"
            `nList` is an array: its index is a `num`, not a `bool`
            | this is a `bool`
            ? `sel(…, 1, 0)` converts a `bool` to a number
        "#]]
        .assert_eq(&word("nList", "num", "bool").to_string());
    }
}
