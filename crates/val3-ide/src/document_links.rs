//! Links from paths in files to other files.

use val3_analysis::db::{Db, File, Project};
use val3_analysis::interfaces::{LoadedPath, uses};
use val3_analysis::items::manifest::{entries, spelling};
use val3_analysis::items::parse;
use val3_analysis::items::project::{find_file, find_project, program_files};
use val3_analysis::xml::{self, XmlElement};
use val3_syntax::{TextRange, text_at};

use crate::owner::owner;

/// A path that resolves to a file.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct DocumentLink {
    /// Range of the path, without quotes.
    pub range: TextRange,
    /// Target file.
    pub target: File,
}

/// Paths in a file, in order: references in a `.pjx`, and library paths in a program.
pub fn document_links(db: &dyn Db, file: File) -> Vec<DocumentLink> {
    let Some(project) = owner(db, file) else { return Vec::new() };
    let mut links = if file == project.manifest(db) { of_manifest(db, project) } else { Vec::new() };
    if program_files(db, project).contains(&file) {
        links.extend(of_program(db, project, file));
    }
    links.sort_by_key(|link| link.range.start());
    links
}

fn of_manifest(db: &dyn Db, project: Project) -> Vec<DocumentLink> {
    let parse = parse(db, project.manifest(db));
    let Some(root) = xml::root(parse.view()) else { return Vec::new() };
    let spelling = spelling(root);
    let files = entries(root, spelling.programs).chain(entries(root, spelling.data));
    let files = files.filter_map(|entry| link(entry, "file", |path| find_file(db, project, path)));
    let manifest = |path: &str| find_project(db, project, path).map(|found| found.manifest(db));
    let libraries = entries(root, spelling.libraries).filter_map(|entry| link(entry, spelling.library_path, manifest));
    let types = entries(root, spelling.types).filter_map(|entry| link(entry, "path", manifest));
    files.chain(libraries).chain(types).collect()
}

fn link(entry: XmlElement<'_>, attribute: &str, find: impl Fn(&str) -> Option<File>) -> Option<DocumentLink> {
    let path = entry.attribute(attribute)?;
    Some(DocumentLink { range: path.range, target: find(&path.text())? })
}

fn of_program(db: &dyn Db, project: Project, file: File) -> impl Iterator<Item = DocumentLink> {
    uses(db, file).loads.iter().filter_map(move |load| {
        let LoadedPath::Whole(path) = &load.path else { return None };
        let target = find_project(db, project, path)?.manifest(db);
        Some(DocumentLink { range: without_quotes(file.text(db), load.range), target })
    })
}

/// Range of a string without its quotes, which may be escaped.
pub(crate) fn without_quotes(text: &str, range: TextRange) -> TextRange {
    let written = text_at(text, range);
    let quote = ["\"", "&quot;", "&#34;"]
        .into_iter()
        .find(|quote| written.len() >= 2 * quote.len() && written.starts_with(quote) && written.ends_with(quote));
    let len = val3_syntax::TextSize::of(quote.unwrap_or(""));
    TextRange::new(range.start() + len, range.end() - len)
}

#[cfg(test)]
mod tests {
    use expect_test::expect;
    use val3_analysis::db::FileRange;

    use super::*;
    use crate::testing::{MarkedListing, shown};

    fn links(listing: &str, of: impl Fn(&MarkedListing) -> File) -> String {
        let marked = MarkedListing::new(listing);
        let db = marked.db();
        let file = of(&marked);
        let lines = document_links(db, file).into_iter().map(|link| {
            let place = shown(db, FileRange { file, range: link.range });
            format!("{place} -> {}\n", link.target.path(db).file_name().unwrap())
        });
        lines.collect()
    }

    const LISTING: &str = "library part \"Disk://part/part.pjx\" autoload=false\nlibrary gone \"Disk://gone/gone.pjx\"\ntype Slot \"Disk://Slot/Slot.pjx\"\nputln(par$0t:libLoad(\"Disk://part\"))\nputln(part:libLoad(\"Disk://nowhere\"))\n--- part\n--- Slot\n";

    #[test]
    fn links_of_code_and_project_files_are_found() {
        expect![[r#"
            main/start.pgx:5 Disk://part -> part.pjx
        "#]]
        .assert_eq(&links(LISTING, |marked| marked.at().file));
        let manifest = |marked: &MarkedListing| owner(marked.db(), marked.at().file).unwrap().manifest(marked.db());
        expect![[r#"
            main/main.pjx:5 start.pgx -> start.pgx
            main/main.pjx:8 main.dtx -> main.dtx
            main/main.pjx:11 Disk://part/part.pjx -> part.pjx
            main/main.pjx:15 Disk://Slot/Slot.pjx -> Slot.pjx
        "#]]
        .assert_eq(&links(LISTING, manifest));
    }
}
