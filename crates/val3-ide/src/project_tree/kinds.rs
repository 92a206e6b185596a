//! Project kinds: applications, and projects that other projects use.

use rustc_hash::{FxHashMap, FxHashSet};
use val3_analysis::application::START;
use val3_analysis::body::body;
use val3_analysis::db::{Db, Project, Sources};
use val3_analysis::interfaces::replacements;
use val3_analysis::items::project::items;
use val3_analysis::test_applications::has_tests;

/// Kind of a project.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum ProjectKind {
    /// An application that the controller starts.
    Application,
    /// An application with tests of other projects.
    Tests,
    /// A library.
    Library,
    /// A user type.
    Type,
}

/// Kinds of all projects in the workspace.
///
/// An application has a program `start`, and no other project uses it as a library or type. Uses by tests do not count.
/// If projects use each other in a circle and no other project uses them, those whose `start` contains code are
/// applications. A remaining project that is only used as a type is a type; all others are libraries.
pub fn project_kinds(db: &dyn Db) -> FxHashMap<Project, ProjectKind> {
    let projects: Vec<Project> = Sources::get(db).projects(db).values().copied().collect();
    let tests: FxHashSet<Project> = projects.iter().copied().filter(|project| has_tests(db, *project)).collect();
    let graph = Graph::of(db, projects.iter().filter(|project| !tests.contains(project)));
    let kind = |project: Project| if tests.contains(&project) { ProjectKind::Tests } else { graph.kind(db, project) };
    projects.iter().map(|project| (*project, kind(*project))).collect()
}

/// Other projects that a project uses.
struct ProjectUses {
    libraries: FxHashSet<Project>,
    types: FxHashSet<Project>,
}

impl ProjectUses {
    fn of(db: &dyn Db, project: Project) -> Self {
        let items = items(db, project);
        let declared = items.libraries.values().filter_map(|library| library.interface);
        let loaded = replacements(db, project).iter().map(|(_, library)| *library);
        let others = |other: &Project| *other != project;
        Self {
            libraries: declared.chain(loaded).filter(others).collect(),
            types: items.types.values().copied().flatten().filter(others).collect(),
        }
    }

    fn all(&self) -> impl Iterator<Item = Project> {
        self.libraries.iter().chain(&self.types).copied()
    }
}

/// Uses of all projects that are not tests.
struct Graph {
    direct: FxHashMap<Project, ProjectUses>,
    /// Projects that each project uses, directly or indirectly.
    all: FxHashMap<Project, FxHashSet<Project>>,
}

impl Graph {
    fn of<'a>(db: &dyn Db, projects: impl Iterator<Item = &'a Project>) -> Self {
        let direct: FxHashMap<Project, ProjectUses> =
            projects.map(|project| (*project, ProjectUses::of(db, *project))).collect();
        let all = direct.keys().map(|project| (*project, reachable(&direct, *project))).collect();
        Self { direct, all }
    }

    fn kind(&self, db: &dyn Db, project: Project) -> ProjectKind {
        let mut users = self.all.iter().filter(|(user, used)| **user != project && used.contains(&project));
        let own = self.all.get(&project);
        let is_used = users.clone().next().is_some();
        let in_circle_alone = users.all(|(user, _)| own.is_some_and(|used| used.contains(user)));
        let start = items(db, project).programs.get(START);
        if start.is_some_and(|start| !is_used || in_circle_alone && !body(db, *start).block.is_empty()) {
            return ProjectKind::Application;
        }
        let is_library = self.direct.values().any(|uses| uses.libraries.contains(&project));
        if is_library || !is_used { ProjectKind::Library } else { ProjectKind::Type }
    }
}

fn reachable(direct: &FxHashMap<Project, ProjectUses>, from: Project) -> FxHashSet<Project> {
    let mut found = FxHashSet::default();
    let mut next = vec![from];
    while let Some(project) = next.pop() {
        let used = direct.get(&project).into_iter().flat_map(ProjectUses::all);
        next.extend(used.filter(|other| found.insert(*other)));
    }
    found
}
