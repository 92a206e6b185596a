//! V0542: file formats that another version requires.

use std::collections::BTreeSet;

use smol_str::SmolStr;
use val3_analysis::items::declarations::{is_old, user_type, version};
use val3_analysis::items::manifest::manifest;
use val3_lang::versions::Version;
use val3_syntax::TextRange;

use super::version_feature::file_in_sub_folder;
use crate::diagnostic::Wording;
use crate::lint::{Findings, ProjectView};
use crate::rule::rule;

rule! {
    /// The files of a project do not have the form that the version reads to which the application is moved.
    ///
    /// ## Why
    /// `val3 check --for s8.10` reports the changes that are required if the applications are moved to that version.
    /// Controllers from s7 on read another form of files than those up to s6, which have no user types. Program files
    /// in sub-folders exist from s8.20 on, and up to s7 a name has at most 15 characters.
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
    if !target.has_user_types() {
        user_types(view, target, found);
    }
    let has_sub_folders = view.items.version.allows_sub_folders() && !target.allows_sub_folders();
    if let Some(range) = file_in_sub_folder(view).filter(|_| has_sub_folders) {
        found.report(&RULE, range, word_sub_folder(target));
    }
    if let Some(limit) = target.identifier_limit().filter(|_| view.items.version.identifier_limit().is_none()) {
        long_names(view, target, limit, declared, found);
    }
}

/// Reports the entries of all user types.
fn user_types(view: &ProjectView<'_>, target: Version, found: &mut Findings) {
    for entry in &manifest(view.db, view.project.manifest(view.db)).types {
        if let Some(place) = user_type(view.db, view.project, entry.name.clone()) {
            found.report(&RULE, place.range, word_type(&entry.name, target));
        }
    }
}

/// Reports the programs and data whose names exceed the limit, as one finding of the project.
fn long_names(view: &ProjectView<'_>, target: Version, limit: usize, declared: TextRange, found: &mut Findings) {
    let names = view.items.programs.keys().chain(view.items.data.keys());
    let long: BTreeSet<&str> = names.map(SmolStr::as_str).filter(|name| name.chars().count() > limit).collect();
    if !long.is_empty() {
        found.report(&RULE, declared, word_long_names(&long, limit, target));
    }
}

/// Maximum number of names in a finding.
const LISTED: usize = 3;

fn word_long_names(names: &BTreeSet<&str>, limit: usize, target: Version) -> Wording {
    let mut shown: Vec<String> = names.iter().take(LISTED).map(|name| format!("`{name}`")).collect();
    if names.len() > LISTED {
        shown.push(format!("{} more", names.len() - LISTED));
    }
    Wording::new(
        format!("names have at most {limit} characters in {target}: {}", shown.join(", ")),
        "names of programs and data are too long",
        "rename them",
    )
}

fn word_type(name: &str, target: Version) -> Wording {
    Wording::new(
        format!("user types exist from s7 on, and {target} does not have `{name}`"),
        format!("not in {target}"),
        "declare the fields as data of their own",
    )
}

fn word_sub_folder(target: Version) -> Wording {
    Wording::new(
        format!("program files in sub-folders exist from s8.20 on, and the application is moved to {target}"),
        "in a sub-folder",
        "put the programs in the folder of the project file",
    )
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
        let listing = "version s7.3\ncls()\n=== val3.toml\n[lint]\ntarget-version = ";
        assert!(check(&RULE, &format!("{listing}\"s6.8\"")).contains("reads that of s5 and s6"));
        assert_eq!(check(&RULE, &format!("{listing}\"s8.10\"")), "");
        assert_eq!(check(&RULE, "version s7.3\ncls()"), "");
    }

    fn with_user_type(target: &str) -> String {
        format!(
            "version s7.3\ntype Part \"Disk://Part/Part.pjx\"\nPart tPart\ntPart.nWeight=1\n--- Part\npublic num nWeight\n\
             === val3.toml\n[lint]\ntarget-version = \"{target}\""
        )
    }

    #[test]
    fn user_types_are_reported_for_versions_without_them() {
        let found = check(&RULE, &with_user_type("s6.8"));
        assert!(found.contains("user types exist from s7 on, and s6.8 does not have `Part`"), "{found}");
        assert_eq!(check(&RULE, &with_user_type("s8.10")), "");
    }

    fn with_long_names(from: &str, to: &str) -> String {
        let names = "num nNumberOfAllPartsA\nnum nNumberOfAllPartsB\nnum nNumberOfAllPartsC\nnum nNumberOfAllPartsD\nnum nShort";
        format!("version {from}\n{names}\ncls()\n=== val3.toml\n[lint]\ntarget-version = \"{to}\"")
    }

    #[test]
    fn names_that_are_too_long_for_the_version_are_one_finding() {
        let found = check(&RULE, &with_long_names("s8.10", "s7.11"));
        let names = "`nNumberOfAllPartsA`, `nNumberOfAllPartsB`, `nNumberOfAllPartsC`, 1 more";
        assert!(found.contains(&format!("names have at most 15 characters in s7.11: {names}")), "{found}");
        assert_eq!(check(&RULE, &with_long_names("s8.10", "s8.20")), "");
    }

    fn check_sub_folder(target: &str) -> String {
        let project = "<Project>\n<Parameters version=\"s8.20\"/>\n<Programs><Program file=\"comm/p.pgx\"/></Programs>\n</Project>";
        let program = "<Programs><Program name=\"p\"><Code><![CDATA[begin\nend]]></Code></Program></Programs>";
        let settings = format!("=== a/val3.toml\n[lint]\ntarget-version = \"{target}\"");
        check(&RULE, &format!("=== a/a.pjx\n{project}\n=== a/comm/p.pgx\n{program}\n{settings}"))
    }

    #[test]
    fn sub_folders_are_reported_for_versions_without_them() {
        let found = check_sub_folder("s8.13");
        assert!(found.contains("program files in sub-folders exist from s8.20 on"), "{found}");
        assert_eq!(check_sub_folder("s8.30"), "");
    }
}
