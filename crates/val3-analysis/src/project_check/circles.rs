//! Projects that use each other in a cycle (6.6).

use std::collections::VecDeque;

use rustc_hash::FxHashMap;
use smol_str::SmolStr;

use super::ProjectCheck;
use crate::db::{Db, Project};
use crate::items::manifest::{Spelling, entries};
use crate::items::project::{find_project, items};
use crate::problem::ProblemKind;
use crate::xml::XmlElement;

type Edges = fn(&dyn Db, Project) -> Vec<Project>;

impl ProjectCheck<'_> {
    /// Reports a cycle of libraries and a cycle of types, each only in the first project of the cycle by path.
    pub(super) fn circles(&mut self, root: XmlElement<'_>, spelling: &Spelling) {
        let lists = [(spelling.libraries, spelling.library_path, libraries as Edges), (spelling.types, "path", types)];
        for (list, path, edges) in lists {
            let Some(chain) = circle(self.db, self.project, edges) else { continue };
            let leads_into = |reference: &str| find_project(self.db, self.project, reference) == chain.get(1).copied();
            let mut paths = entries(root, list).filter_map(|element| element.attribute(path));
            let Some(entry) = paths.find(|path| leads_into(&path.text())) else { continue };
            let chain = chain.into_iter().map(|project| name(self.db, project)).collect();
            self.found.report(entry.range, ProblemKind::LibraryCircle { chain });
        }
    }
}

fn path(db: &dyn Db, project: Project) -> &str {
    project.manifest(db).path(db).as_str()
}

fn name(db: &dyn Db, project: Project) -> SmolStr {
    project.manifest(db).path(db).file_stem().unwrap_or("").into()
}

fn libraries(db: &dyn Db, project: Project) -> Vec<Project> {
    items(db, project).libraries.values().filter_map(|library| library.interface).collect()
}

fn types(db: &dyn Db, project: Project) -> Vec<Project> {
    items(db, project).types.values().copied().flatten().collect()
}

/// Returns the shortest cycle from `start` along `edges`, with `start` at both ends. Only projects whose path is not
/// less than the path of `start` are visited, so that only one project of a cycle finds it.
fn circle(db: &dyn Db, start: Project, edges: Edges) -> Option<Vec<Project>> {
    let mut from: FxHashMap<Project, Project> = FxHashMap::default();
    let mut queue = VecDeque::from([start]);
    while let Some(at) = queue.pop_front() {
        let mut next = edges(db, at);
        next.retain(|next| path(db, *next) >= path(db, start));
        next.sort_unstable_by_key(|next| path(db, *next));
        for next in next {
            if next == start {
                return Some(way(&from, start, at));
            }
            if let std::collections::hash_map::Entry::Vacant(unseen) = from.entry(next) {
                unseen.insert(at);
                queue.push_back(next);
            }
        }
    }
    None
}

/// Returns `start`, the path to `last`, and `start` again.
fn way(from: &FxHashMap<Project, Project>, start: Project, last: Project) -> Vec<Project> {
    let back = std::iter::successors(Some(last), |at| from.get(at).copied());
    let mut way: Vec<Project> = std::iter::once(start).chain(back).collect();
    way.reverse();
    way
}
