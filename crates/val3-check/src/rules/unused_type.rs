//! V0119: a user type that is never used.

use rustc_hash::FxHashSet;
use smol_str::SmolStr;
use val3_analysis::application::unlisted_may_use;
use val3_analysis::items::data::data;
use val3_analysis::items::declarations;
use val3_analysis::items::manifest::manifest;
use val3_analysis::items::program::header;
use val3_analysis::items::project::{data_files, items, program_files, resolve_type};

use crate::diagnostic::Wording;
use crate::lint::{Findings, ProjectView, removal};
use crate::rule::rule;

rule! {
    /// A project declares a user type that none of its data, parameters and locals has.
    ///
    /// ## Why
    /// The entry is left over. It is needed and not reported if a library of the project has data of this type.
    ///
    /// ## Bad
    /// ```val3
    /// type Slot "Disk://Slot/Slot.pjx"
    /// putln("ready")
    /// --- Slot
    /// public num nWeight
    /// ```
    ///
    /// ## Good
    /// ```val3
    /// type Slot "Disk://Slot/Slot.pjx"
    /// private Slot slFirst
    /// putln(slFirst.nWeight)
    /// --- Slot
    /// public num nWeight
    /// ```
    V0119 "unused-type" Info, Project: check
}

fn check(view: &ProjectView<'_>, found: &mut Findings) {
    if !view.application().sound || view.items.types.is_empty() {
        return;
    }
    let named = named_types(view);
    // An unknown type may be a misspelling of these types.
    if named.iter().any(|name| resolve_type(&view.items.types, name).is_none()) {
        return;
    }
    for entry in &manifest(view.db, view.project.manifest(view.db)).types {
        let is_used = named.contains(&entry.name)
            || is_used_by_library(view, &entry.name)
            || unlisted_may_use(view.db, view.project, &entry.name);
        let place = declarations::user_type(view.db, view.project, entry.name.clone());
        if let Some(place) = place.filter(|_| !is_used) {
            found.report(&RULE, place.range, word(&entry.name)).fix(
                format!("remove `{}`", entry.name),
                false,
                removal::of_entry(view.db, place.file, place.range),
            );
        }
    }
}

/// Types in the declarations of the project.
fn named_types(view: &ProjectView<'_>) -> FxHashSet<SmolStr> {
    let db = view.db;
    let of_data = data_files(db, view.project).iter().flat_map(|file| data(db, *file)).map(|decl| &decl.type_name);
    let headers = || program_files(db, view.project).iter().map(|file| header(db, *file));
    let of_params = headers().flat_map(|header| &header.params).map(|param| &param.type_name);
    let of_locals = headers().flat_map(|header| &header.locals).map(|local| &local.type_name);
    of_data.chain(of_params).chain(of_locals).cloned().collect()
}

/// Whether a library or another type of the project also has the type.
fn is_used_by_library(view: &ProjectView<'_>, name: &str) -> bool {
    let Some(Some(ty)) = view.items.types.get(name) else { return true };
    let libraries = view.items.libraries.values().filter_map(|library| library.interface);
    let others = view.items.types.values().flatten().copied();
    libraries.chain(others).any(|other| items(view.db, other).types.values().any(|known| *known == Some(*ty)))
}

fn word(name: &str) -> Wording {
    Wording::new(format!("nothing in the project has the user type `{name}`"), "never used", "remove the entry")
}

#[cfg(test)]
mod tests {
    use expect_test::expect;

    use super::*;
    use crate::lint::testing::check;

    const TYPE: &str = "--- Slot\npublic num nW\n";

    #[test]
    fn a_type_that_is_never_named_is_reported() {
        expect![[r#"
            main.pjx:12 `Slot` nothing in the project has the user type `Slot`
              | never used
              ? remove the entry
              ! remove `Slot` (unsafe)
        "#]]
        .assert_eq(&check(&RULE, &format!("type Slot \"Disk://Slot/Slot.pjx\"\ncls()\n{TYPE}")));
    }

    #[test]
    fn a_misspelt_type_may_be_its_use() {
        assert_eq!(check(&RULE, &format!("type Slot \"Disk://Slot/Slot.pjx\"\nprivate Slt slA\n{TYPE}")), "");
    }

    #[test]
    fn data_parameters_locals_and_libraries_are_uses() {
        let head = "type Slot \"Disk://Slot/Slot.pjx\"\n";
        assert_eq!(check(&RULE, &format!("{head}private Slot slA\n{TYPE}")), "");
        assert_eq!(check(&RULE, &format!("{head}program p(Slot x_slA)\nbegin\nend\n{TYPE}")), "");
        assert_eq!(check(&RULE, &format!("{head}program p()\n  Slot l_slA\nbegin\nend\n{TYPE}")), "");
        let library =
            "library part \"Disk://part/part.pjx\"\n--- part\ntype Slot \"Disk://Slot/Slot.pjx\"\npublic Slot slA\n";
        assert_eq!(check(&RULE, &format!("{head}{library}{TYPE}")), "");
    }
}
