//! V0212: a constant index outside the array.

use crate::{diagnostic::Wording, rule::rule};

rule! {
    /// A constant index is outside the array.
    ///
    /// ## Why
    /// The first element of an array has the index 0, and the last one its size less 1 (2.5.3). An index below 0 stops
    /// the task with run-time error 21, one that is too large with error 20. The rule examines constant indexes of
    /// arrays whose size never changes. A line that is only executed if `size` or `isDefined` finds the element is not
    /// reported, nor is a line that is never executed, such as the block of `if false`.
    ///
    /// ## Bad
    /// ```val3
    /// program clear()
    ///   num l_nList[3]
    /// begin
    ///   l_nList[3]=0
    /// end
    /// ```
    ///
    /// ## Good
    /// ```val3
    /// program clear()
    ///   num l_nList[3]
    /// begin
    ///   l_nList[2]=0
    /// end
    /// ```
    V0212 "index-out-of-bounds" Error
}

/// Returns the wording of the finding.
pub(crate) fn word(name: &str, index: i64, size: usize) -> Wording {
    let possible = match size {
        0 => "no index is possible".to_owned(),
        1 => "only 0 is possible".to_owned(),
        _ => format!("0 to {} are possible", size - 1),
    };
    let help = match usize::try_from(index) {
        Ok(index) if index == size => "the first index is 0, so the last one is the size less 1",
        _ => "",
    };
    Wording::new(format!("the index {index} is outside `{name}`"), possible, help)
}

#[cfg(test)]
mod tests {
    use expect_test::expect;

    use super::word;

    #[test]
    fn the_message_says_what_is_wrong() {
        expect![[r#"
            the index 3 is outside `l_nList`
            | 0 to 2 are possible
            ? the first index is 0, so the last one is the size less 1
        "#]]
        .assert_eq(&word("l_nList", 3, 3).to_string());
        expect![[r#"
            the index -1 is outside `nCount`
            | only 0 is possible
        "#]]
        .assert_eq(&word("nCount", -1, 1).to_string());
    }
}
