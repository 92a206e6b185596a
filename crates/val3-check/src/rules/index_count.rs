//! V0210: too many or too few indexes.

use crate::{diagnostic::Wording, english::count, rule::rule};

rule! {
    /// The number of indexes differs from the number of dimensions of the array.
    ///
    /// ## Why
    /// An element of an array needs one index for each dimension, from 0 to the size of the dimension less 1 (2.5.3).
    /// The controller does not load an application with fewer or more indexes. VAL 3 has no arrays of arrays: all
    /// indexes are written in one pair of brackets.
    ///
    /// ## Bad
    /// ```val3
    /// num nGrid[3,4]
    ///
    /// nGrid[2]=1
    /// ```
    ///
    /// ## Good
    /// ```val3
    /// num nGrid[3,4]
    ///
    /// nGrid[2,0]=1
    /// ```
    V0210 "index-count" Error
}

/// Returns the wording of the finding.
pub(crate) fn word(name: &str, expected: usize, found: usize) -> Wording {
    let places = vec!["…"; expected].join(",");
    Wording::new(
        format!("`{name}` has {} and takes {}, not {found}", count(expected, "dimension"), count(expected, "index")),
        count(found, "index"),
        format!("write `{name}[{places}]`"),
    )
}

#[cfg(test)]
mod tests {
    use expect_test::expect;

    use super::word;

    #[test]
    fn the_message_says_what_is_wrong() {
        expect![[r#"
            `nGrid` has 2 dimensions and takes 2 indexes, not 1
            | 1 index
            ? write `nGrid[…,…]`
        "#]]
        .assert_eq(&word("nGrid", 2, 1).to_string());
        expect![[r#"
            `nList` has 1 dimension and takes 1 index, not 3
            | 3 indexes
            ? write `nList[…]`
        "#]]
        .assert_eq(&word("nList", 1, 3).to_string());
    }
}
