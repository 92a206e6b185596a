//! Comparison of a library with an interface.

use smol_str::{SmolStr, format_smolstr};

use super::{Interfaces, is_public};
use crate::db::{Db, File, FileRange, Project};
use crate::items::declarations;
use crate::items::project::{DataItem, Signature, items, signature};
use crate::problem::{NameKind, Problem, ProblemKind, Related, RelatedRole};
use crate::ty::brackets;

/// An interface item, and the library that is searched for its counterpart.
struct ItemPair<'a> {
    alias: &'a SmolStr,
    library: &'a SmolStr,
    item: &'a SmolStr,
    what: NameKind,
    /// Location where the library is loaded.
    load: FileRange,
    /// Location of the item's declaration in the interface.
    interface: Option<FileRange>,
}

impl Interfaces<'_> {
    /// Reports differences of `library` from the interface of `alias`; `load` is the location where the library is
    /// loaded.
    pub(super) fn compare(&mut self, alias: &SmolStr, library: Project, load: FileRange) {
        let db = self.db;
        let interface = items(db, self.project).libraries.get(alias).and_then(|item| item.interface);
        let Some(interface) = interface.filter(|interface| *interface != library) else { return };
        let (wanted, offered) = (items(db, interface), items(db, library));
        let library_name: SmolStr = library.manifest(db).path(db).file_stem().unwrap_or("").into();
        let mut missing = Vec::new();
        for item in self.needed(alias) {
            let pair = |what, interface| ItemPair { alias, library: &library_name, item: &item, what, load, interface };
            if let Some(data) = wanted.data.get(&item).filter(|data| data.decl.public) {
                let place = declarations::data(db, data.file, item.clone());
                let pair = pair(NameKind::Data, place);
                match offered.data.get(&item) {
                    Some(found) => self.data(&pair, data, found),
                    None if offered.lacks_data => {}
                    None => missing.push((NameKind::Data, item.clone(), place)),
                }
            } else if let Some(&file) = wanted.programs.get(&item) {
                let signature = signature(db, interface, file);
                if signature.public {
                    let place = declarations::program(db, file);
                    let pair = pair(NameKind::Program, place);
                    match offered.programs.get(&item) {
                        Some(&found) => self.program(&pair, signature, library, found),
                        None if offered.may_have_program(&item) => {}
                        None => missing.push((NameKind::Program, item.clone(), place)),
                    }
                }
            }
        }
        self.missing(alias, library_name, missing, load);
    }

    /// Returns the items that programs use without first checking that they exist. A library without the other items is
    /// loaded; the controller only reports code 11.
    pub(super) fn needed(&self, alias: &SmolStr) -> Vec<SmolStr> {
        let used = self.programs.iter().flat_map(|(_, uses)| &uses.items);
        let used = used.filter(|(library, _)| library == alias);
        let unguarded = used.filter(|item| !self.programs.iter().any(|(_, uses)| uses.guarded.contains(item)));
        let mut needed: Vec<SmolStr> = unguarded.map(|(_, item)| item.clone()).collect();
        needed.sort_unstable();
        needed.dedup();
        needed
    }

    fn data(&mut self, pair: &ItemPair<'_>, wanted: &DataItem, found: &DataItem) {
        let there = declarations::data(self.db, found.file, pair.item.clone());
        if !found.decl.may_be_public() {
            self.private(pair, there);
        } else if !same_data(wanted, found) {
            self.different(pair, data_line(wanted, pair.item), data_line(found, pair.item), there);
        }
    }

    fn program(&mut self, pair: &ItemPair<'_>, wanted: &Signature, library: Project, file: File) {
        let db = self.db;
        let found = signature(db, library, file);
        let there = declarations::program(db, file);
        if !found.public {
            self.private(pair, there);
        } else if !same_parameters(wanted, found) {
            self.different(pair, wanted.syntax_line(db), found.syntax_line(db), there);
        }
    }

    /// Reports all missing items of a library as one problem, because usually the entire library is wrong.
    fn missing(
        &mut self,
        alias: &SmolStr,
        library: SmolStr,
        items: Vec<(NameKind, SmolStr, Option<FileRange>)>,
        load: FileRange,
    ) {
        if items.is_empty() {
            return;
        }
        let related =
            items.iter().filter_map(|(.., place)| Some(Related { place: (*place)?, role: RelatedRole::Interface }));
        let related = related.collect();
        let items = items.into_iter().map(|(what, item, _)| (what, item)).collect();
        let kind = ProblemKind::ImplementationMissing { alias: alias.clone(), library, items };
        self.problems.push(Problem { kind, place: load, related });
    }

    fn private(&mut self, pair: &ItemPair<'_>, there: Option<FileRange>) {
        let kind = ProblemKind::ImplementationPrivate {
            alias: pair.alias.clone(),
            library: pair.library.clone(),
            item: pair.item.clone(),
            what: pair.what,
        };
        self.push(kind, pair, there);
    }

    fn different(&mut self, pair: &ItemPair<'_>, expected: SmolStr, found: SmolStr, there: Option<FileRange>) {
        let kind = ProblemKind::ImplementationDifferent {
            alias: pair.alias.clone(),
            library: pair.library.clone(),
            item: pair.item.clone(),
            what: pair.what,
            expected,
            found,
        };
        self.push(kind, pair, there);
    }

    fn push(&mut self, kind: ProblemKind, pair: &ItemPair<'_>, there: Option<FileRange>) {
        let interface = pair.interface.map(|place| Related { place, role: RelatedRole::Interface });
        let there = there.map(|place| Related { place, role: RelatedRole::Implementation });
        let related = interface.into_iter().chain(there).collect();
        self.problems.push(Problem { kind, place: pair.load, related });
    }
}

/// Whether `library` has the item of `interface`, public and of the same kind.
pub fn implements(db: &dyn Db, interface: Project, library: Project, item: &str) -> bool {
    is_public(db, library, item) && is_same_item(db, interface, library, item).unwrap_or(false)
}

/// Returns whether two projects' items with this name agree in type or parameters, so that a library with one item can
/// be loaded for an interface with the other; `None` if one of the projects has no such item.
pub fn is_same_item(db: &dyn Db, interface: Project, library: Project, item: &str) -> Option<bool> {
    let (wanted, found) = (items(db, interface), items(db, library));
    if let Some(data) = wanted.data.get(item) {
        return found.data.get(item).map(|found| same_data(data, found));
    }
    let wanted = signature(db, interface, *wanted.programs.get(item)?);
    found.programs.get(item).map(|file| same_parameters(wanted, signature(db, library, *file)))
}

/// Whether type and container agree. Sizes may differ, because instructions change them.
fn same_data(wanted: &DataItem, found: &DataItem) -> bool {
    wanted.base.same_as(found.base) && wanted.decl.container == found.decl.container
}

/// Whether types, containers and passing modes agree. Names may differ, and unreadable parameters are assumed to agree.
fn same_parameters(wanted: &Signature, found: &Signature) -> bool {
    if !wanted.complete || !found.complete {
        return true;
    }
    wanted.params.len() == found.params.len()
        && wanted.params.iter().zip(&found.params).all(|(a, b)| {
            let same_passing = a.container == b.container && a.by_reference == b.by_reference;
            a.base.same_as(b.base) && (a.loose || b.loose || same_passing)
        })
}

/// Formats a declaration, for example `num nSize[3]`.
fn data_line(item: &DataItem, name: &str) -> SmolStr {
    let ty = &item.decl.type_name;
    match item.decl.sizes.as_slice() {
        [1] => format_smolstr!("{ty} {name}"),
        [] => format_smolstr!("{ty} {name}{}", brackets(item.decl.container)),
        sizes => {
            let sizes: Vec<String> = sizes.iter().map(u32::to_string).collect();
            format_smolstr!("{ty} {name}[{}]", sizes.join(", "))
        }
    }
}
