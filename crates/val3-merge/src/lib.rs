//! Three-way merge of controller files: data, projects, programs and configuration.
//!
//! The merge reads all three versions as trees. Data are matched by name, array elements by index or key, list entries
//! by their key, and code by lines. The result is the text of ours with edits. Text that theirs has not changed is
//! preserved byte for byte. If both sides have changed the same value, ours remains, a comment before it contains the
//! values of base and theirs, and the parser of VAL 3 files reports this comment as an unresolved conflict. In code,
//! the lines of both sides are between the marks of version control.
//!
//! **A clean result contains every change of both sides.** A text that is no well-formed XML is merged by lines, which
//! is never a clean result.

mod array;
mod attributes;
mod children;
mod conflict;
mod diff3;
mod kind;
mod lines;
mod merger;
mod moved;
mod node;
mod placement;
mod plan;
mod renumber;
mod same;
#[cfg(test)]
mod tests;
mod text;

use rustc_hash::{FxHashMap, FxHashSet};
use smol_str::SmolStr;
use val3_syntax::TextEdit;
use val3_syntax::xml::line_end;

pub use conflict::Conflict;
pub use kind::MergedKind;
pub use moved::Moved;

use crate::merger::{ElementVersions, Merger};
use crate::node::{MergeNode, parse, read};
use crate::plan::{Plans, plans};

/// Result of a merge.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct MergeResult {
    /// Merged text. It is well-formed XML if `by_lines` is `None`.
    pub text: String,
    /// Contradicting changes of both sides. The text contains both versions.
    pub conflicts: Vec<Conflict>,
    /// Array elements that theirs has appended and whose indexes differ in the merged text.
    pub moved: Vec<Moved>,
    /// Reason why the texts were merged by lines; `None` if they were merged as XML.
    pub by_lines: Option<String>,
}

impl MergeResult {
    /// Whether the text contains all changes, so that no person has to check it.
    #[must_use]
    pub fn is_clean(&self) -> bool {
        self.conflicts.is_empty() && self.by_lines.is_none()
    }

    fn unchanged(text: &str) -> Self {
        Self { text: text.to_owned(), conflicts: Vec::new(), moved: Vec::new(), by_lines: None }
    }
}

/// Merges the changes of `ours` and `theirs` since `base`, which is empty if both sides have added the file.
#[must_use]
pub fn merge(kind: MergedKind, base: &str, ours: &str, theirs: &str) -> MergeResult {
    if base == theirs || ours == theirs {
        return MergeResult::unchanged(ours);
    }
    if base == ours {
        return MergeResult::unchanged(theirs);
    }
    match trees(kind, base, ours, theirs) {
        Ok(merged) => merged,
        Err(reason) => {
            let (text, lines) = lines::merge_files(base, ours, theirs, line_end(ours));
            let paths = lines.into_iter().map(|line| format!("line {line}"));
            let conflicts = paths.map(|path| Conflict { path, reason: "both sides have changed it".to_owned() });
            MergeResult { text, conflicts: conflicts.collect(), moved: Vec::new(), by_lines: Some(reason) }
        }
    }
}

/// Merges trees.
///
/// # Errors
/// If the texts cannot be merged as trees, with the reason.
fn trees(kind: MergedKind, base: &str, ours: &str, theirs: &str) -> Result<MergeResult, String> {
    let parses = [base, ours, theirs].map(parse);
    let [base_parse, our_parse, their_parse] = &parses;
    let has_base = !base.trim_start_matches('\u{feff}').trim().is_empty();
    let base_tree = if has_base { Some(tree(kind, base_parse, base, "BASE")?) } else { None };
    let our_tree = tree(kind, our_parse, ours, "OURS")?;
    let their_tree = tree(kind, their_parse, theirs, "THEIRS")?;
    check_roots([base_tree.as_ref(), Some(&our_tree), Some(&their_tree)])?;
    let plans = match &base_tree {
        Some(base) if kind == MergedKind::Data => plans(base, &our_tree, &their_tree),
        _ => FxHashMap::default(),
    };
    let renumbered = TextEdit::apply_all(theirs, &renumber::edits(&their_tree, &plans));
    let their_parse = parse(&renumbered);
    let their_tree = tree(kind, &their_parse, &renumbered, "THEIRS")?;
    let merged = merged(kind, &plans, [base_tree.as_ref(), Some(&our_tree), Some(&their_tree)], ours);
    let parse = parse(&merged.text);
    // Edits of a well-formed tree yield a well-formed tree; any other result must not be accepted.
    tree(kind, &parse, &merged.text, "the result")?;
    Ok(merged)
}

fn tree<'t>(
    kind: MergedKind,
    parse: &'t val3_syntax::Parse,
    text: &'t str,
    name: &str,
) -> Result<MergeNode<'t>, String> {
    read(kind, parse, text).ok_or_else(|| format!("{name} is not well-formed XML"))
}

/// Checks that all versions have the same dialect.
fn check_roots(files: [Option<&MergeNode<'_>>; 3]) -> Result<(), String> {
    let mut roots: Vec<&str> = files.into_iter().flatten().map(root_name).collect();
    roots.dedup();
    match roots.as_slice() {
        [_] => Ok(()),
        roots => Err(format!("the versions have different root elements: `{}`", roots.join("`, `"))),
    }
}

fn root_name<'n>(file: &'n MergeNode<'_>) -> &'n str {
    file.children.iter().map(MergeNode::name).find(|name| !name.is_empty()).unwrap_or_default()
}

fn merged(
    kind: MergedKind,
    plans: &Plans,
    [base, ours, theirs]: [Option<&MergeNode<'_>>; 3],
    text: &str,
) -> MergeResult {
    let added = match (kind, ours) {
        (MergedKind::Data, Some(ours)) => added_data(base, ours),
        _ => FxHashSet::default(),
    };
    let line_end = line_end(text);
    let mut merger = Merger { kind, plans, added, edits: Vec::new(), conflicts: Vec::new(), line_end };
    if let (Some(ours), Some(theirs)) = (ours, theirs) {
        merger.children(ElementVersions { base, ours, theirs }, "");
    }
    merger.edits.sort_by_key(|edit| (edit.range.start(), edit.range.end()));
    MergeResult {
        text: TextEdit::apply_all(text, &merger.edits),
        conflicts: merger.conflicts,
        moved: moved::of(plans),
        by_lines: None,
    }
}

/// Returns the names of data that ours has added or declared with another type. A file of s5 or s6 has a section for each
/// type, so merging may add one name to two sections.
fn added_data(base: Option<&MergeNode<'_>>, ours: &MergeNode<'_>) -> FxHashSet<SmolStr> {
    let old: FxHashMap<SmolStr, String> = base.into_iter().flat_map(declarations).collect();
    declarations(ours).filter(|(name, id)| old.get(name) != Some(id)).map(|(name, _)| name).collect()
}

/// Returns the names and identities of the declarations in a file.
fn declarations<'n>(file: &'n MergeNode<'_>) -> impl Iterator<Item = (SmolStr, String)> + 'n {
    let lists = file.children.iter().flat_map(|root| &root.children);
    lists.flat_map(|list| &list.children).filter_map(|data| Some((data.key.clone()?, data.id.clone())))
}
