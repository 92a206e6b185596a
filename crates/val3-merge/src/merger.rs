//! Merge of an element: its attributes, then its content.

use rustc_hash::FxHashSet;
use smol_str::SmolStr;
use val3_syntax::{TextEdit, TextRange};

use crate::attributes;
use crate::conflict::{Conflict, Ours, comment};
use crate::kind::MergedKind;
use crate::node::MergeNode;
use crate::placement::{adapted, before, prefix};
use crate::plan::{Plan, Plans, path_of};
use crate::same::same;

/// Elements of s5 and s6 that are one value in several parts, such as `valuePoint` with `tpValue` and `cpValue`.
const PLACES: [&str; 5] = ["valueTrsf", "valueFrame", "valueTool", "valuePoint", "valueJoint"];

/// Collects the edits of ours.
pub(crate) struct Merger<'m> {
    pub(crate) kind: MergedKind,
    pub(crate) plans: &'m Plans,
    /// Names of data that ours has added.
    pub(crate) added: FxHashSet<SmolStr>,
    pub(crate) edits: Vec<TextEdit>,
    pub(crate) conflicts: Vec<Conflict>,
    /// Line end of ours.
    pub(crate) line_end: &'static str,
}

/// The base, our and their version of an element.
#[derive(Clone, Copy)]
pub(crate) struct ElementVersions<'n, 't> {
    pub(crate) base: Option<&'n MergeNode<'t>>,
    pub(crate) ours: &'n MergeNode<'t>,
    pub(crate) theirs: &'n MergeNode<'t>,
}

impl Merger<'_> {
    /// Merges an element that is in ours and theirs. `around` is the path of the parent element.
    pub(crate) fn element(&mut self, versions: ElementVersions<'_, '_>, around: &str) {
        let ElementVersions { base, ours, theirs } = versions;
        let kind = self.kind;
        let path = self.path(around, ours);
        if same(kind, ours, theirs) || base.is_some_and(|base| same(kind, base, theirs)) {
            return;
        }
        let is_ours_unchanged = base.is_some_and(|base| same(kind, base, ours));
        match self.plans.get(&path).filter(|_| ours.key.is_some() && kind == MergedKind::Data) {
            Some(Plan::Replace) => return self.replace(ours, theirs),
            Some(Plan::Conflict(reason)) => return self.conflict(versions, &path, (*reason).to_owned()),
            Some(Plan::Append(_)) => attributes::merge(self, versions, &path, &["size"]),
            None if is_unit(kind, versions) && is_ours_unchanged => return self.replace(ours, theirs),
            None if is_unit(kind, versions) => {
                return self.conflict(versions, &path, "ours and theirs differ".to_owned());
            }
            None => attributes::merge(self, versions, &path, &[]),
        }
        if ours.has_text || theirs.has_text {
            self.text(versions, &path);
        } else if kind.is_ordered(ours.name()) {
            self.ordered(versions, &path);
        } else {
            self.children(versions, &path);
        }
    }

    /// Returns the path of `node` for messages.
    pub(crate) fn path(&self, around: &str, node: &MergeNode<'_>) -> String {
        match self.kind {
            MergedKind::Data => path_of(around, node),
            MergedKind::Program | MergedKind::Project => match node.key.as_deref() {
                Some(key) => format!("{} {key}", node.name().to_lowercase()),
                None => node.name().to_owned(),
            },
            MergedKind::Settings => {
                let key = node.key.as_deref().map(|key| format!("[{key}]")).unwrap_or_default();
                format!("{around} {}{key}", node.name()).trim_start().to_owned()
            }
        }
    }

    /// Replaces an element of ours, which is unchanged since the base, by the element of theirs.
    pub(crate) fn replace(&mut self, ours: &MergeNode<'_>, theirs: &MergeNode<'_>) {
        let insert = adapted(theirs, ours.line_end, Some(prefix(ours)));
        self.edits.push(TextEdit { range: ours.range, text: insert });
    }

    /// Reports a conflict of entire elements. Ours remains, and a comment before it contains the other versions.
    pub(crate) fn conflict(&mut self, versions: ElementVersions<'_, '_>, path: &str, reason: String) {
        let ElementVersions { base, ours, theirs } = versions;
        self.conflict_at(ours, path, reason, [base.map(MergeNode::text), Some(theirs.text())]);
    }

    /// Reports a conflict at an element of ours, with the texts of base and theirs.
    pub(crate) fn conflict_at(&mut self, ours: &MergeNode<'_>, path: &str, reason: String, others: [Option<&str>; 2]) {
        let text = self.report(path, reason, Ours::Follows, others);
        self.edits.push(before(ours, &text));
    }

    /// Reports a conflict. Returns the comment with the texts of base and theirs.
    pub(crate) fn report(&mut self, path: &str, reason: String, ours: Ours, others: [Option<&str>; 2]) -> String {
        let conflict = Conflict { path: path.to_owned(), reason };
        let text = comment(&conflict, ours, others, self.line_end);
        self.conflicts.push(conflict);
        text
    }

    /// Replaces a range of ours.
    pub(crate) fn edit(&mut self, range: TextRange, text: String) {
        self.edits.push(TextEdit { range, text });
    }
}

/// Whether the parts of the element form one value, so that changes on both sides are a conflict.
fn is_unit(kind: MergedKind, ElementVersions { base, ours, theirs }: ElementVersions<'_, '_>) -> bool {
    let nodes = || [base, Some(ours), Some(theirs)].into_iter().flatten();
    let is_place = kind == MergedKind::Data && PLACES.iter().any(|place| ours.name().starts_with(place));
    // Both sides have added an element with the same key.
    let is_new = base.is_none() && ours.key.is_some();
    is_place || is_new || nodes().any(|node| node.has_text && !node.children.is_empty())
}
