//! V0206: an array or collection where another container is needed.

use val3_lang::instructions;

use crate::{diagnostic::Wording, english::container, rule::rule};

rule! {
    /// A parameter for an array or collection receives a different container.
    ///
    /// ## Why
    /// A parameter `num& x[]` is linked to a whole one-dimensional array of the caller, `num& x[,]` to a
    /// two-dimensional one, and `num& x[""]` to a collection. Only a one-dimensional array can be passed in part, from
    /// an index on; single data counts as an array of one element (2.6.3). The controller does not load an application
    /// that passes another container.
    ///
    /// ## Bad
    /// ```val3
    /// num nWeight[""]
    ///
    /// call clear(nWeight)
    ///
    /// program clear(num& x_nList[])
    /// begin
    ///   x_nList[0]=0
    /// end
    /// ```
    ///
    /// ## Good
    /// ```val3
    /// num nWeight[3]
    ///
    /// call clear(nWeight)
    ///
    /// program clear(num& x_nList[])
    /// begin
    ///   x_nList[0]=0
    /// end
    /// ```
    V0206 "container-mismatch" Error
}

/// Returns the wording of the finding.
pub(crate) fn word(callee: &str, parameter: &str, expected: &str, found: &str) -> Wording {
    let (takes, got) = (container(expected), container(found));
    Wording::new(
        format!("`{callee}` takes {takes} (`{expected}`) as `{parameter}`, not {got} (`{found}`)"),
        format!("this is {got}"),
        advice(callee, expected, found),
    )
}

/// Advice for the usual mistakes.
fn advice(callee: &str, expected: &str, found: &str) -> &'static str {
    if instructions::resizes(callee) {
        return "use `resize`, which changes arrays of all dimensions";
    }
    match (expected.contains('['), found.contains('[')) {
        (true, false) => "pass a whole array or collection, without an index or key",
        (false, true) => "pass one element, with its index or key",
        _ => "",
    }
}

#[cfg(test)]
mod tests {
    use expect_test::expect;

    use super::word;

    #[test]
    fn the_message_names_both_containers() {
        expect![[r#"
            `clear` takes a one-dimensional array (`num[]`) as `x_nList`, not a collection (`num[""]`)
            | this is a collection
        "#]]
        .assert_eq(&word("clear", "x_nList", "num[]", "num[\"\"]").to_string());
    }

    #[test]
    fn only_one_instruction_changes_arrays_of_several_dimensions() {
        expect![[r#"
            `delete` takes a one-dimensional array (`num[]`) as `variable`, not a two-dimensional array (`num[,]`)
            | this is a two-dimensional array
            ? use `resize`, which changes arrays of all dimensions
        "#]]
        .assert_eq(&word("delete", "variable", "num[]", "num[,]").to_string());
    }

    #[test]
    fn an_element_for_a_container_is_reported() {
        expect![[r#"
            `send` takes a two-dimensional array (`string[,]`) as `x_sGrid`, not a single value (`string`)
            | this is a single value
            ? pass a whole array or collection, without an index or key
        "#]]
        .assert_eq(&word("send", "x_sGrid", "string[,]", "string").to_string());
    }
}
