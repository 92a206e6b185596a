//! V0507: an element in the wrong place.

use val3_lang::suggest::nearest;

use crate::{diagnostic::Wording, phrase::did_you_mean, rule::rule};

rule! {
    /// The file format has no such element in this place.
    ///
    /// ## Why
    /// The format defines the elements that a project, a data file and a program may contain, and their places. An
    /// element that is misplaced or misspelt has no meaning there, and the value or entry that it was meant to give is
    /// missing when the application runs. Letter case matters: `value` is not `Value`. A program file contains one
    /// program: a second one is not found by its name.
    ///
    /// ## Bad
    /// ```val3
    /// putln("ready")
    ///
    /// === main/main.dtx
    /// <?xml version="1.0" encoding="utf-8"?>
    /// <Database xmlns:xsi="http://www.w3.org/2001/XMLSchema-instance" xmlns="http://www.staubli.com/robotics/VAL3/Data/2">
    ///   <Datas>
    ///     <Data name="nCount" access="private" xsi:type="array" type="num" size="1">
    ///       <value key="0" value="3" />
    ///     </Data>
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
    /// <Database xmlns:xsi="http://www.w3.org/2001/XMLSchema-instance" xmlns="http://www.staubli.com/robotics/VAL3/Data/2">
    ///   <Datas>
    ///     <Data name="nCount" access="private" xsi:type="array" type="num" size="1">
    ///       <Value key="0" value="3" />
    ///     </Data>
    ///   </Datas>
    /// </Database>
    /// ```
    V0507 "unexpected-element" Warning
}

/// Elements of s7 and s8.
const ELEMENTS: &[&str] = &[
    "Project",
    "Parameters",
    "Programs",
    "Program",
    "Database",
    "Data",
    "Libraries",
    "Library",
    "Types",
    "Type",
    "Datas",
    "Value",
    "Field",
    "Description",
    "Parameter",
    "Locals",
    "Local",
    "Code",
];

/// Program element and its parent, in both dialects.
const PROGRAMS: &[(&str, &str)] = &[("Program", "Programs"), ("program", "programList")];

/// Returns the wording of the finding.
pub(crate) fn word(name: &str, parent: &str) -> Wording {
    if PROGRAMS.contains(&(name, parent)) {
        return Wording::new(
            "a program file holds one program, and this is the second",
            "nothing can call it",
            "move it to a separate file, and list that in the project",
        );
    }
    Wording::new(
        format!("the element `{name}` does not belong in `{parent}`"),
        "it has no meaning here",
        did_you_mean(nearest(name, ELEMENTS.iter().copied())),
    )
}

#[cfg(test)]
mod tests {
    use expect_test::expect;

    use super::*;

    #[test]
    fn wrong_letter_case_is_reported() {
        expect![[r#"
            the element `value` does not belong in `Data`
            | it has no meaning here
            ? did you mean `Value`?
        "#]]
        .assert_eq(&word("value", "Data").to_string());
    }

    #[test]
    fn a_misspelt_element_is_reported() {
        expect![[r#"
            the element `Vlaue` does not belong in `Data`
            | it has no meaning here
            ? did you mean `Value`?
        "#]]
        .assert_eq(&word("Vlaue", "Data").to_string());
    }

    #[test]
    fn a_second_program_is_reported() {
        let expected = expect![[r#"
            a program file holds one program, and this is the second
            | nothing can call it
            ? move it to a separate file, and list that in the project
        "#]];
        expected.assert_eq(&word("Program", "Programs").to_string());
        expected.assert_eq(&word("program", "programList").to_string());
        assert!(word("Program", "Datas").to_string().contains("does not belong"));
    }

    #[test]
    fn a_known_element_in_the_wrong_place_is_reported() {
        expect![[r#"
            the element `Library` does not belong in `Programs`
            | it has no meaning here
        "#]]
        .assert_eq(&word("Library", "Programs").to_string());
    }
}
