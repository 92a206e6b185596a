//! The `.pjx`: its entries, the files they name, and circles among libraries and types.

use rustc_hash::FxHashMap;
use smol_str::SmolStr;
use val3_lang::versions::Version;
use val3_syntax::TextRange;
use val3_syntax::view::View;

use crate::db::{Db, File, FileStatus, Project};
use crate::declared_name::{self, NameCheck};
use crate::items::manifest::{Spelling, entries, manifest, spelling};
use crate::items::parse;
use crate::items::project::{find_file, find_project, folder, items};
use crate::paths::{self, Target};
use crate::problem::{FileRole, NameKind, Place, Problem, ProblemKind, Related, Role};
use crate::xml::{self, Attribute, Element};

/// What is wrong in a project file.
#[salsa::tracked]
pub fn problems(db: &dyn Db, project: Project) -> Vec<Problem> {
    let file = project.manifest(db);
    let parse = parse(db, file);
    let view = View::root(parse.green());
    if let FileStatus::Unreadable(reason) = file.status(db) {
        let kind = ProblemKind::FileUnreadable { reason: reason.as_str().into() };
        return vec![declared_name::problem(file, view.range(), kind)];
    }
    let mut check = ProjectCheck { db, project, file, names: NameCheck::new(file, items(db, project)) };
    check.names.problems.extend(declared_name::encoding(db, file));
    if let Some(root) = xml::root(view) {
        check.root(root);
    }
    check.names.problems
}

struct ProjectCheck<'db> {
    db: &'db dyn Db,
    project: Project,
    file: File,
    names: NameCheck<'db>,
}

impl ProjectCheck<'_> {
    fn report(&mut self, range: TextRange, kind: ProblemKind) {
        self.names.report(range, kind);
    }

    fn root(&mut self, root: Element<'_>) {
        if !matches!(root.name(), "Project" | "project") {
            let kind = ProblemKind::WrongRoot { expected: FileRole::Project, found: root.name().into() };
            return self.report(root.name_range(), kind);
        }
        let spelling = spelling(root);
        self.children(root, spelling);
        self.version(root, spelling);
        self.files(root, spelling.programs, FileRole::Program);
        self.files(root, spelling.data, FileRole::Data);
        let alias = if spelling.root == "project" { "name" } else { "alias" };
        self.projects(root, spelling.libraries, (alias, spelling.library_path), FileRole::Library);
        self.projects(root, spelling.types, ("name", "path"), FileRole::Type);
        self.circle(root, spelling);
    }

    fn children(&mut self, root: Element<'_>, spelling: &Spelling) {
        let lists = [spelling.programs, spelling.data, spelling.libraries, spelling.types];
        for element in root.elements() {
            let list = lists.iter().find(|(list, _)| *list == element.name());
            match list {
                Some((_, item)) => {
                    for inner in element.elements().filter(|inner| inner.name() != *item) {
                        self.unexpected(inner, element);
                    }
                }
                None if element.name() == spelling.parameters => {}
                None => self.unexpected(element, root),
            }
        }
    }

    fn unexpected(&mut self, element: Element<'_>, parent: Element<'_>) {
        let kind = ProblemKind::UnexpectedElement { name: element.name().into(), parent: parent.name().into() };
        self.report(element.name_range(), kind);
    }

    fn version(&mut self, root: Element<'_>, spelling: &Spelling) {
        let Some(parameters) = root.child(&[spelling.parameters]) else { return };
        let Some(version) = parameters.attribute("version").filter(|version| !version.raw.trim().is_empty()) else {
            return;
        };
        if Version::parse(&version.text()).is_none() {
            self.invalid(parameters, version, "a version such as `s7.11.3`");
        }
    }

    fn invalid(&mut self, element: Element<'_>, attribute: Attribute<'_>, expected: &'static str) {
        let kind = ProblemKind::InvalidAttribute {
            element: element.name().into(),
            attribute: attribute.name.into(),
            value: attribute.text().as_ref().into(),
            expected: SmolStr::new_static(expected),
        };
        self.report(attribute.range, kind);
    }

    fn missing(&mut self, element: Element<'_>, attribute: &'static str) {
        let kind = ProblemKind::MissingAttribute {
            element: element.name().into(),
            attribute: SmolStr::new_static(attribute),
        };
        self.report(element.name_range(), kind);
    }

    /// Program and data files.
    fn files(&mut self, root: Element<'_>, list: (&'static str, &'static str), what: FileRole) {
        let mut seen: FxHashMap<String, TextRange> = FxHashMap::default();
        for element in entries(root, list) {
            let Some(file) = element.attribute("file") else {
                self.missing(element, "file");
                continue;
            };
            let path = file.text();
            if let Some(first) = seen.insert(path.to_lowercase(), file.range) {
                self.duplicate(file, first, what);
            } else if find_file(self.db, self.project, &path).is_none() {
                self.report(file.range, ProblemKind::FileMissing { what, path: path.as_ref().into() });
            }
        }
    }

    /// Libraries and user types.
    fn projects(
        &mut self,
        root: Element<'_>,
        list: (&'static str, &'static str),
        (name, path): (&'static str, &'static str),
        what: FileRole,
    ) {
        let mut seen: FxHashMap<String, TextRange> = FxHashMap::default();
        let kind = if what == FileRole::Library { NameKind::Library } else { NameKind::Type };
        for element in entries(root, list) {
            match element.attribute(name) {
                None => self.missing(element, name),
                Some(found) => {
                    self.names.name(found, kind);
                    let name = found.text();
                    if let Some(first) = seen.insert(name.to_string(), found.range) {
                        self.duplicate(found, first, what);
                    }
                }
            }
            match element.attribute(path) {
                None => self.missing(element, path),
                Some(found) => self.target(found, what),
            }
            if let Some(autoload) = element.attribute("autoload")
                && !matches!(autoload.text().trim(), "true" | "false")
            {
                self.invalid(element, autoload, "`true` or `false`");
            }
        }
    }

    fn duplicate(&mut self, found: Attribute<'_>, first: TextRange, what: FileRole) {
        let place = Place { file: self.file, range: first };
        self.names.problems.push(Problem {
            kind: ProblemKind::DuplicateEntry { what, name: found.text().as_ref().into() },
            place: Place { file: self.file, range: found.range },
            related: vec![Related { place, role: Role::First }],
        });
    }

    fn target(&mut self, path: Attribute<'_>, what: FileRole) {
        let db = self.db;
        let reference = path.text();
        let target = paths::project(folder(db, self.project), self.project.disk(db).as_deref(), &reference);
        if target != Target::Elsewhere && find_project(db, self.project, &reference).is_none() {
            self.report(path.range, ProblemKind::FileMissing { what, path: reference.as_ref().into() });
        }
    }

    /// Projects that use each other in a circle (6.6). The first of them by path reports it.
    fn circle(&mut self, root: Element<'_>, spelling: &Spelling) {
        for (list, path, edges) in [
            (spelling.libraries, spelling.library_path, libraries as fn(&dyn Db, Project) -> Vec<Project>),
            (spelling.types, "path", types),
        ] {
            for element in entries(root, list) {
                let Some(found) = element.attribute(path) else { continue };
                let Some(next) = find_project(self.db, self.project, &found.text()) else { continue };
                let Some(chain) = way_back(self.db, next, self.project, edges) else { continue };
                let own = self.path(self.project);
                if chain.iter().all(|project| self.path(*project) >= own) {
                    let names = std::iter::once(self.project).chain(chain).map(|project| self.name(project));
                    self.report(found.range, ProblemKind::LibraryCircle { chain: names.collect() });
                    break;
                }
            }
        }
    }

    fn path(&self, project: Project) -> &str {
        project.manifest(self.db).path(self.db).as_str()
    }

    fn name(&self, project: Project) -> SmolStr {
        project.manifest(self.db).path(self.db).file_stem().unwrap_or("").into()
    }
}

fn libraries(db: &dyn Db, project: Project) -> Vec<Project> {
    let manifest = manifest(db, project.manifest(db));
    manifest.libraries.iter().filter_map(|entry| find_project(db, project, &entry.path)).collect()
}

fn types(db: &dyn Db, project: Project) -> Vec<Project> {
    let manifest = manifest(db, project.manifest(db));
    manifest.types.iter().filter_map(|entry| find_project(db, project, &entry.path)).collect()
}

/// The shortest way from `start` to `goal` along `edges`, both included.
fn way_back(
    db: &dyn Db,
    start: Project,
    goal: Project,
    edges: fn(&dyn Db, Project) -> Vec<Project>,
) -> Option<Vec<Project>> {
    let mut from: FxHashMap<Project, Project> = FxHashMap::default();
    let mut queue = std::collections::VecDeque::from([start]);
    while let Some(at) = queue.pop_front() {
        if at == goal {
            let mut way = vec![at];
            let mut step = at;
            while step != start {
                step = *from.get(&step)?;
                way.push(step);
            }
            way.reverse();
            return Some(way);
        }
        for next in edges(db, at) {
            if next != start && !from.contains_key(&next) {
                from.insert(next, at);
                queue.push_back(next);
            }
        }
    }
    None
}
