//! V0542: the form of files that another version reads.

use val3_analysis::items::declarations::{is_old, version};

use crate::diagnostic::Wording;
use crate::lint::{Findings, ProjectView};
use crate::rule::rule;

rule! {
    /// The files of a project do not have the form that the version reads to which the application is moved.
    ///
    /// ## Why
    /// `val3 check --for s8.10` reports what has to change if the applications are moved to that version. Controllers
    /// from s7 on read another form of files than those up to s6, and program files in sub-folders exist from s8.20 on.
    ///
    /// ## Bad
    /// ```val3
    /// version s7.3
    /// putln("ready")
    ///
    /// === val3.toml
    /// [lint]
    /// target-version = "s6.8"
    /// ```
    ///
    /// ## Good
    /// ```val3
    /// version s7.3
    /// putln("ready")
    ///
    /// === val3.toml
    /// [lint]
    /// target-version = "s7.11"
    /// ```
    V0542 "other-version-project" Warning, Project: check
}

fn check(view: &ProjectView<'_>, found: &mut Findings) {
    let Some(target) = view.options.target_version else { return };
    let Some(declared) = version(view.db, view.project) else { return };
    let is_old = is_old(view.db, view.project);
    if is_old == target.has_user_types() {
        let (form, other) = if is_old { ("s5 and s6", "s7") } else { ("s7", "s5 and s6") };
        found.report(&RULE, declared, word(&target.to_string(), form, other));
    }
}

fn word(target: &str, form: &str, other: &str) -> Wording {
    Wording::new(
        format!("the files have the form of {form}, and {target} reads that of {other}"),
        format!("the form of {form}"),
        "open the application in the vendor's tool for that version and save it there",
    )
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::lint::testing::check;

    #[test]
    fn only_another_form_is_reported() {
        let listing =
            |target: &str| format!("version s7.3\ncls()\n=== val3.toml\n[lint]\ntarget-version = \"{target}\"");
        assert!(check(&RULE, &listing("s6.8")).contains("reads that of s5 and s6"));
        assert_eq!(check(&RULE, &listing("s8.10")), "");
        assert_eq!(check(&RULE, "version s7.3\ncls()"), "");
    }
}
