//! Symbol search in the workspace.

use val3_analysis::db::{Db, FileRange, Project, Sources};
use val3_analysis::items::project::items;
use val3_analysis::occurrences::Symbol;
use val3_syntax::{TextRange, TextSize};

use super::{SymbolKind, WorkspaceSymbol};
use crate::fuzzy::score;
use crate::navigate::declaration;

/// Names that match `query`, the most probable first; at most `limit`.
pub fn workspace_symbols(db: &dyn Db, query: &str, limit: usize) -> Vec<WorkspaceSymbol> {
    let mut found: Vec<SymbolCandidate> = Vec::new();
    let mut projects: Vec<Project> = Sources::get(db).projects(db).values().copied().collect();
    projects.sort_unstable_by_key(|project| project.manifest(db).path(db));
    for project in projects {
        for (kind, symbol, name) in names(db, project) {
            if let Some(score) = score(query, &name) {
                found.push(SymbolCandidate { score, name, kind, symbol, project });
            }
        }
    }
    // By score, then by name. The sort is stable, so equal names keep the project order.
    found.sort_by(|a, b| b.score.cmp(&a.score).then_with(|| a.name.cmp(&b.name)));
    // Locations are only looked up for the returned names.
    found.into_iter().filter_map(|candidate| candidate.placed(db)).take(limit).collect()
}

struct SymbolCandidate {
    score: i32,
    name: String,
    kind: SymbolKind,
    /// `None` for the project itself.
    symbol: Option<Symbol>,
    project: Project,
}

impl SymbolCandidate {
    fn placed(self, db: &dyn Db) -> Option<WorkspaceSymbol> {
        let place = place(db, &self.symbol, self.project)?;
        let container = self.project.manifest(db).path(db).file_stem().unwrap_or("").to_owned();
        Some(WorkspaceSymbol { name: self.name.into(), container, kind: self.kind, place })
    }
}

fn names(db: &dyn Db, project: Project) -> Vec<(SymbolKind, Option<Symbol>, String)> {
    let items = items(db, project);
    let title = project.manifest(db).path(db).file_stem().unwrap_or("").to_owned();
    let mut names = vec![(SymbolKind::Project, None, title)];
    names.extend(
        items
            .programs
            .keys()
            .map(|name| (SymbolKind::Program, Some(Symbol::Program(project, name.clone())), name.to_string())),
    );
    names.extend(
        items.data.keys().map(|name| (SymbolKind::Data, Some(Symbol::Data(project, name.clone())), name.to_string())),
    );
    names.extend(
        items
            .libraries
            .keys()
            .map(|name| (SymbolKind::Library, Some(Symbol::Library(project, name.clone())), name.to_string())),
    );
    names
}

fn place(db: &dyn Db, symbol: &Option<Symbol>, project: Project) -> Option<FileRange> {
    match symbol {
        Some(symbol) => declaration(db, symbol),
        None => Some(FileRange { file: project.manifest(db), range: TextRange::empty(TextSize::new(0)) }),
    }
}

#[cfg(test)]
mod tests {
    use expect_test::expect;

    use super::*;
    use crate::testing::MarkedListing;

    #[test]
    fn the_best_match_comes_first() {
        let marked = MarkedListing::new("num nCount\nnum nCounter\nnum nOther\nnCount=1\nprogram count()\nbegin\nend");
        let shown = |query| first_three(&marked, query);
        expect![[r#"
            Program count
            Data nCount
            Data nCounter
        "#]]
        .assert_eq(&shown("count"));
        expect![[r#"
            Data nCounter
        "#]]
        .assert_eq(&shown("ncr"));
        expect![[r#""#]].assert_eq(&shown("zz"));
    }

    fn first_three(marked: &MarkedListing, query: &str) -> String {
        let found = workspace_symbols(marked.db(), query, 3);
        found.iter().map(|symbol| format!("{:?} {}\n", symbol.kind, symbol.name)).collect()
    }
}
