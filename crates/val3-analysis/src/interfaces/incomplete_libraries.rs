//! Libraries whose project file does not list the used items, usually because a newly created `.pjx` replaced the
//! original one. All uses have this one cause, so one problem is reported at the library's entry.

use std::collections::BTreeMap;

use camino::Utf8Path;
use rustc_hash::{FxHashMap, FxHashSet};
use smol_str::SmolStr;

use super::Interfaces;
use super::usage::is_instruction;
use crate::application::ENTRY_POINTS;
use crate::body::{Expr, ExprId, body};
use crate::db::{Db, File, FileRange, Project};
use crate::items::declarations;
use crate::items::manifest::manifest;
use crate::items::project::items;
use crate::items::unlisted::{Unlisted, unlisted};
use crate::problem::{NameKind, Problem, ProblemKind, Related, RelatedRole};

fn may_leave_out(db: &dyn Db, library: Project) -> bool {
    is_empty(db, library) || *unlisted(db, library) != Unlisted::default()
}

fn is_empty(db: &dyn Db, library: Project) -> bool {
    let items = items(db, library);
    items.programs.is_empty() && items.data.is_empty()
}

/// Whether the folder contains more unlisted programs than the project lists, so that the `.pjx` does not belong to the
/// files. A newly created `.pjx` lists `start`, `stop` and its own data.
fn lists_few(db: &dyn Db, library: Project) -> bool {
    let stem = |file: &str| Utf8Path::new(file).file_stem().unwrap_or("").to_ascii_lowercase();
    let listed = manifest(db, library.manifest(db)).programs.iter();
    let listed = listed.filter(|file| !ENTRY_POINTS.contains(&stem(file).as_str())).count();
    unlisted(db, library).programs.len() > listed
}

/// Whether the item may be missing because the library's project does not list the file that contains it, or lists few
/// files or no file in its folder.
pub(crate) fn is_left_out(db: &dyn Db, library: Project, item: &str, what: NameKind) -> bool {
    let unlisted = unlisted(db, library);
    let may_hold_it = match what {
        NameKind::Program => unlisted.has_program(item),
        _ => !unlisted.data.is_empty() && manifest(db, library.manifest(db)).data.is_empty(),
    };
    may_hold_it || is_empty(db, library) || lists_few(db, library)
}

/// A used item and the location of the use.
type ItemUse = (SmolStr, FileRange);

impl Interfaces<'_> {
    /// Reports uses of items that library projects omit: one problem for each library.
    pub(super) fn left_out(&mut self) {
        let db = self.db;
        let libraries = items(db, self.project).libraries.iter();
        let libraries: FxHashMap<&SmolStr, Project> = libraries
            .filter_map(|(alias, library)| Some((alias, library.interface?)))
            .filter(|(_, library)| may_leave_out(db, *library))
            .collect();
        let mut found: BTreeMap<SmolStr, Vec<ItemUse>> = BTreeMap::new();
        for (file, uses) in &self.programs {
            if uses.items.iter().any(|(alias, _)| libraries.contains_key(alias)) {
                collect_uses(db, *file, &libraries, &mut found);
            }
        }
        for (alias, uses) in found {
            let library = libraries.get(&alias).copied();
            let place = declarations::library(db, self.project, alias.clone());
            self.problems.extend(library.zip(place).map(|(library, place)| problem(db, alias, library, place, &uses)));
        }
    }
}

fn problem(db: &dyn Db, alias: SmolStr, library: Project, place: FileRange, uses: &[ItemUse]) -> Problem {
    let mut missing: Vec<SmolStr> = uses.iter().map(|(item, _)| item.clone()).collect();
    missing.sort_unstable();
    missing.dedup();
    let list = declarations::file_list(db, library, true);
    let list = list.map(|list| FileRange { file: library.manifest(db), range: list.place });
    let list = list.into_iter().map(|place| Related { place, role: RelatedRole::List });
    let uses_of_items = uses.iter().map(|(_, place)| Related { place: *place, role: RelatedRole::Use });
    let related = list.chain(uses_of_items).collect();
    let unlisted = unlisted(db, library).all();
    Problem { kind: ProblemKind::LibraryLeftOut { alias, missing, unlisted, uses: uses.len() }, place, related }
}

/// Collects the items of `libraries` that the program in `file` uses and that are missing because they are not listed.
fn collect_uses(
    db: &dyn Db,
    file: File,
    libraries: &FxHashMap<&SmolStr, Project>,
    found: &mut BTreeMap<SmolStr, Vec<ItemUse>>,
) {
    let body = body(db, file);
    let callee = |expr: &Expr| if let Expr::Call(callee, _) = expr { Some(*callee) } else { None };
    let callees: FxHashSet<ExprId> = body.exprs().filter_map(|(_, expr, _)| callee(expr)).collect();
    for (id, expr, range) in body.exprs() {
        let Expr::Path { library: alias, item } = expr else { continue };
        let Some(library) = libraries.get(alias).filter(|_| !is_instruction(item)) else { continue };
        let what = if callees.contains(&id) { NameKind::Program } else { NameKind::Data };
        if is_missing(db, *library, item, what) && is_left_out(db, *library, item, what) {
            found.entry(alias.clone()).or_default().push((item.clone(), FileRange { file, range }));
        }
    }
}

fn is_missing(db: &dyn Db, library: Project, item: &str, what: NameKind) -> bool {
    let items = items(db, library);
    match what {
        NameKind::Program => !items.programs.contains_key(item) && !items.may_have_program(item),
        _ => !items.data.contains_key(item) && !items.programs.contains_key(item) && !items.lacks_data,
    }
}
