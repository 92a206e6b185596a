//! V0536: a required element is missing.

use crate::{diagnostic::Wording, rule::rule};

rule! {
    /// A program file has no program, or a program has no code.
    ///
    /// ## Why
    /// A program file contains one `Program` with its `Code`, from `begin` to `end`, even where the program does
    /// nothing. The controller reports "no code" and does not load the application.
    ///
    /// ## Bad
    /// ```val3
    /// call run()
    ///
    /// === main/run.pgx
    /// <?xml version="1.0" encoding="utf-8"?>
    /// <Programs xmlns="http://www.staubli.com/robotics/VAL3/Program/2">
    ///   <Program name="run">
    ///   </Program>
    /// </Programs>
    /// ```
    ///
    /// ## Good
    /// ```val3
    /// call run()
    ///
    /// === main/run.pgx
    /// <?xml version="1.0" encoding="utf-8"?>
    /// <Programs xmlns="http://www.staubli.com/robotics/VAL3/Program/2">
    ///   <Program name="run">
    ///     <Code><![CDATA[begin
    /// end]]></Code>
    ///   </Program>
    /// </Programs>
    /// ```
    V0536 "missing-element" Error
}

/// Returns the wording of the finding.
pub(crate) fn word(parent: &str, element: &str) -> Wording {
    Wording::new(format!("the element `{parent}` has no `{element}`"), format!("`{element}` is missing"), help(element))
}

fn help(element: &str) -> &'static str {
    match element {
        "Code" | "code" | "source" => "a program without instructions has the code `begin`, `end`",
        _ => "remove the file from the project if it is not needed",
    }
}

#[cfg(test)]
mod tests {
    use expect_test::expect;

    use super::*;

    #[test]
    fn a_program_without_code_element_is_reported() {
        expect![[r#"
            the element `Program` has no `Code`
            | `Code` is missing
            ? a program without instructions has the code `begin`, `end`
        "#]]
        .assert_eq(&word("Program", "Code").to_string());
    }

    #[test]
    fn a_file_without_program_element_is_reported() {
        expect![[r#"
            the element `Programs` has no `Program`
            | `Program` is missing
            ? remove the file from the project if it is not needed
        "#]]
        .assert_eq(&word("Programs", "Program").to_string());
    }
}
