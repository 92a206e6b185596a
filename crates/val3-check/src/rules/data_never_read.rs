//! V0116: private data that programs write but never read.

use val3_analysis::items::declarations::Declared;
use val3_lang::types::BaseType;

use crate::diagnostic::Wording;
use crate::lint::{DataFile, Findings, ProjectView, unused_data};
use crate::rule::rule;

rule! {
    /// Programs write private data, but no program reads it.
    ///
    /// ## Why
    /// Data that is never read is not needed, or a program reads the wrong data: often one of two similar names. Data
    /// may be written only so that people can watch it on the pendant. Inputs and outputs are not reported, because
    /// writing them is their use.
    ///
    /// ## Bad
    /// ```val3
    /// num nDone
    ///
    /// program start()
    /// begin
    ///   nDone=1
    /// end
    /// ```
    ///
    /// ## Good
    /// ```val3
    /// num nDone
    ///
    /// program start()
    /// begin
    ///   nDone=1
    ///   putln(nDone)
    /// end
    /// ```
    V0116 "data-never-read" Info, Data: check
}

fn check(data: &DataFile<'_>, found: &mut Findings) {
    let view = &data.view;
    if !unused_data::has_known_uses(view) {
        return;
    }
    for Declared { name, range, .. } in unused_data::declared(data, |name| is_only_written(view, name)) {
        found.report(&RULE, range, word(&name));
    }
}

/// Whether programs write the data and none may read them. Writing an output has an effect.
fn is_only_written(view: &ProjectView<'_>, name: &str) -> bool {
    let base = view.items.data.get(name).and_then(|item| item.base.builtin());
    unused_data::uses(view, name).is_some_and(|uses| uses.written && !uses.may_read())
        && !base.is_some_and(BaseType::is_linkable)
}

fn word(name: &str) -> Wording {
    Wording::new(format!("programs write `{name}`, but no program reads it"), "never read", "remove it, or read it")
}

#[cfg(test)]
mod tests {
    use expect_test::expect;

    use super::*;
    use crate::lint::testing::check;

    #[test]
    fn data_that_are_only_written_are_reported() {
        expect![[r#"
            main.dtx:4 `nA` programs write `nA`, but no program reads it
              | never read
              ? remove it, or read it
            main.dtx:5 `trB` programs write `trB`, but no program reads it
              | never read
              ? remove it, or read it
        "#]]
        .assert_eq(&check(&RULE, "num nA\ntrsf trB\nprogram start()\nbegin\n  nA=1\n  trB.x=2\nend"));
    }

    #[test]
    fn data_that_are_read_anywhere_are_not_reported() {
        let listing = "num nA[3]\nnum nB\nnum nC\nnum nD\nprogram start()\nbegin\n  nB=1\n  nA[nB]=2\n  nA[0]=nA[1]\n  \
                       nC=nC+1\n  for nD=0 to 3\n  endFor\nend";
        assert_eq!(check(&RULE, listing), "");
    }

    #[test]
    fn data_passed_by_reference_are_not_reported() {
        let listing = "bool bA\nnum nB\nprogram start()\nbegin\n  setMutex(bA)\n  bA=false\n  nB=1\n  call p(nB)\nend\n\
                       program p(num& x_n)\nbegin\nend";
        assert_eq!(check(&RULE, listing), "");
    }

    #[test]
    fn outputs_are_not_reported() {
        assert_eq!(check(&RULE, "dio doA\naio aoB\nprogram start()\nbegin\n  doA=true\n  aoB=1\nend"), "");
    }
}
