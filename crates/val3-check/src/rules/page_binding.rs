//! V0560: a user page that names what the application does not have.

use val3_analysis::problem::PageFault;

use crate::{diagnostic::Wording, phrase::did_you_mean_or, rule::rule};

rule! {
    /// The bindings of a user page name data, an index, a program or an element that does not exist, or a program shows a
    /// page that does not exist.
    ///
    /// ## Why
    /// `interface/<page>.bindings.json` connects elements of the page to data of the application, and events of elements to
    /// programs without parameters (s8). A name that leads nowhere shows no value, and a click does nothing. `userPage` returns
    /// -1 for a page without an HTML file.
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

/// Words the finding.
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
            did_you_mean_or(near.as_deref(), "give the element of the HTML file this id, or correct the binding"),
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
            ? give the element of the HTML file this id, or correct the binding
            the application has no page `nopage`
            | no HTML file in the folder `interface`
            ? add the page, or correct the name
        "#]]
        .assert_eq(&words);
    }
}
