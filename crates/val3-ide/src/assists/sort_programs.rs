//! Sorts the programs or data in a project file by name.

use val3_analysis::items::manifest::{entries, spelling};
use val3_analysis::xml;
use val3_syntax::TextRange;

use super::context::Context;
use super::{AssistKind, Assists};
use crate::edit::{FileEdit, SourceChange};

pub(super) fn offer(context: &Context<'_>, assists: &mut Assists<'_>) -> Option<()> {
    if context.file != context.project.manifest(context.db) {
        return None;
    }
    let edits = sorted(context)?;
    assists.add("sort-programs", AssistKind::Organise, "Sort programs by name", || Some(SourceChange::of(edits)));
    Some(())
}

/// Edits that sort the elements; `None` if they are already sorted.
fn sorted(context: &Context<'_>) -> Option<Vec<FileEdit>> {
    let parse = val3_analysis::items::parse(context.db, context.file);
    let root = xml::root(parse.view())?;
    let found = entries(root, spelling(root).programs);
    let entries: Vec<(String, TextRange)> =
        found.map(|entry| (entry.value("file").unwrap_or_default().to_lowercase(), entry.view().range())).collect();
    let mut wanted = entries.clone();
    wanted.sort_by(|a, b| a.0.cmp(&b.0));
    let pairs = entries.iter().zip(&wanted).filter(|((_, here), (_, there))| here != there);
    let edits: Vec<FileEdit> =
        pairs.map(|((_, here), (_, there))| context.replace(*here, context.slice(*there))).collect();
    (!edits.is_empty()).then_some(edits)
}

#[cfg(test)]
mod tests {
    use expect_test::expect;

    use crate::assists::testing::{check, offered};

    fn project(programs: &str) -> String {
        format!(
            "=== main/main.pjx\n<Project>\n  <Parameters version=\"s7.11\" />\n$0  <Programs>\n{programs}  </Programs>\n  <Database />\n</Project>\n"
        )
    }

    #[test]
    fn programs_are_sorted_by_name() {
        let listing = project(
            "    <Program file=\"stop.pgx\" />\n    <!-- first -->\n    <Program file=\"Pick.pgx\"></Program>\n    <Program file=\"start.pgx\" />\n",
        );
        check(
            "sort-programs",
            &listing,
            expect![[r#"
            usrapp/main/main.pjx
            -    <Program file="stop.pgx" />
            -    <!-- first -->
            -    <Program file="Pick.pgx"></Program>
            -    <Program file="start.pgx" />
            +    <Program file="Pick.pgx"></Program>
            +    <!-- first -->
            +    <Program file="start.pgx" />
            +    <Program file="stop.pgx" />
        "#]],
        );
    }

    #[test]
    fn sorted_programs_are_not_offered() {
        let listing = project("    <Program file=\"a.pgx\" />\n    <Program file=\"B.pgx\" />\n");
        assert_eq!(offered(&listing, "sort-programs"), None);
    }
}
