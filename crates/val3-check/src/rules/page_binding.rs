//! V0560: a user page that names an unknown item of the application.

use val3_analysis::problem::PageFault;

use crate::{diagnostic::Wording, phrase::did_you_mean_or, rule::rule};

rule! {
    /// The bindings of a user page name data, an index, a program or an element that does not exist, bind a value that an
    /// attribute cannot show, or a program shows a page that does not exist.
    ///
    /// ## Why
    /// `interface/<page>.bindings.json` connects elements of the page to data of the application, and events of
    /// elements to programs without parameters (s8). An unresolved name shows no value, and a click does nothing.
    /// `userPage` returns
    /// -1 for a page without an HTML file. An attribute has one value: a position or an object has several, so that it cannot be
    /// shown completely. If two elements have the same id, the page changes only one.
    ///
    /// ## Bad
    /// ```val3
    /// version s8.10
    /// num nCount
    /// nCount=1
    ///
    /// === main/interface/main.html
    /// <html><body><label id="lblCount"></label></body></html>
    /// === main/interface/main.bindings.json
    /// {"version":"1.0","bindings":[{"id":"lblCount","attribute":"innerHTML","data":"nCuont[0]","size":1,"direction":"r"}]}
    /// ```
    ///
    /// ## Good
    /// ```val3
    /// version s8.10
    /// num nCount
    /// nCount=1
    ///
    /// === main/interface/main.html
    /// <html><body><label id="lblCount"></label></body></html>
    /// === main/interface/main.bindings.json
    /// {"version":"1.0","bindings":[{"id":"lblCount","attribute":"innerHTML","data":"nCount[0]","size":1,"direction":"r"}]}
    /// ```
    V0560 "page-binding" Warning
}

/// Returns the wording of the finding.
pub(crate) fn word(fault: &PageFault) -> Wording {
    match fault {
        PageFault::NoJson { expected } => Wording::new(
            format!("the bindings of this page are no JSON: {expected} is expected"),
            "not expected here",
            "correct the file; the page shows no data until then",
        ),
        PageFault::UnknownData { name, near } => Wording::new(
            format!("the application has no data `{name}`"),
            "no data of the application",
            did_you_mean_or(near.as_deref(), "declare the data, or correct the binding"),
        ),
        PageFault::UnknownField { name, of_type, near } => Wording::new(
            format!("the type `{of_type}` has no field `{name}`"),
            "no field of the type",
            did_you_mean_or(near.as_deref(), "declare public data of the type, or correct the binding"),
        ),
        PageFault::SeveralValues { path, found, attribute } => Wording::new(
            format!("the attribute `{attribute}` has one value, and `{path}` is a value of the type `{found}`"),
            "a bool, num or string is expected here",
            "bind data of one of these types, to which a program writes what the page shows",
        ),
        PageFault::Index { name, index, size } => Wording::new(
            format!("`{name}` has no element `[{index}]`"),
            format!("its size is {size}"),
            "correct the index; the first element is 0",
        ),
        PageFault::UnknownProgram { name, near } => Wording::new(
            format!("the application has no program `{name}`"),
            "no program of the application",
            did_you_mean_or(near.as_deref(), "add the program, or correct the binding"),
        ),
        PageFault::Parameters { name } => Wording::new(
            format!("the page calls `{name}` without arguments, but the program has parameters"),
            "a program with parameters",
            "bind a program without parameters",
        ),
        PageFault::UnknownElement { id, near } => Wording::new(
            format!("the page has no element with the id `{id}`"),
            "no id of the page",
            did_you_mean_or(near.as_deref(), "set this id in the HTML element, or correct the binding"),
        ),
        PageFault::ElementTwice { id } => Wording::new(
            format!("two elements of the page have the id `{id}`"),
            "the second element with this id",
            "use a different id for each element; a binding refers to one element",
        ),
        PageFault::UnknownPage { name, near } => Wording::new(
            format!("the application has no page `{name}`"),
            "no HTML file in the folder `interface`",
            did_you_mean_or(near.as_deref(), "add the page, or correct the name"),
        ),
    }
}

#[cfg(test)]
mod tests {
    use expect_test::expect;

    use super::*;

    #[test]
    fn each_fault_names_what_is_missing() {
        let near = Some("clkStart".into());
        let faults = [
            PageFault::NoJson { expected: "a string" },
            PageFault::Index { name: "sInfo".into(), index: "7".into(), size: "1".into() },
            PageFault::UnknownProgram { name: "clkStrat".into(), near },
            PageFault::Parameters { name: "move".into() },
            PageFault::UnknownElement { id: "btn".into(), near: None },
            PageFault::UnknownField { name: "nHigth".into(), of_type: "Slot".into(), near: Some("nHeight".into()) },
            PageFault::SeveralValues { path: "pPick[0]".into(), found: "point".into(), attribute: "innerHTML".into() },
            PageFault::ElementTwice { id: "btn".into() },
            PageFault::UnknownPage { name: "nopage".into(), near: None },
        ];
        let words: String = faults.iter().map(|fault| word(fault).to_string()).collect();
        expect![[r#"
            the bindings of this page are no JSON: a string is expected
            | not expected here
            ? correct the file; the page shows no data until then
            `sInfo` has no element `[7]`
            | its size is 1
            ? correct the index; the first element is 0
            the application has no program `clkStrat`
            | no program of the application
            ? did you mean `clkStart`?
            the page calls `move` without arguments, but the program has parameters
            | a program with parameters
            ? bind a program without parameters
            the page has no element with the id `btn`
            | no id of the page
            ? set this id in the HTML element, or correct the binding
            the type `Slot` has no field `nHigth`
            | no field of the type
            ? did you mean `nHeight`?
            the attribute `innerHTML` has one value, and `pPick[0]` is a value of the type `point`
            | a bool, num or string is expected here
            ? bind data of one of these types, to which a program writes what the page shows
            two elements of the page have the id `btn`
            | the second element with this id
            ? use a different id for each element; a binding refers to one element
            the application has no page `nopage`
            | no HTML file in the folder `interface`
            ? add the page, or correct the name
        "#]]
        .assert_eq(&words);
    }
}
