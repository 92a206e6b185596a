//! Merge of child elements: by identity, in the order of ours.

use rustc_hash::FxHashMap;

use crate::conflict::Ours;
use crate::merger::{ElementVersions, Merger};
use crate::node::MergeNode;
use crate::placement::{adapted, after, before, inside, prefix, prefix_in, removed};
use crate::same::{is_default, same};

/// Elements with one identity in three versions.
#[derive(Default)]
struct ElementGroup<'n, 't> {
    base: Vec<&'n MergeNode<'t>>,
    ours: Vec<&'n MergeNode<'t>>,
    theirs: Vec<&'n MergeNode<'t>>,
}

impl Merger<'_> {
    /// Merges the children if the element is in ours and theirs.
    pub(crate) fn children(&mut self, versions: ElementVersions<'_, '_>, path: &str) {
        let ElementVersions { base, ours, theirs } = versions;
        let mut groups: FxHashMap<&str, ElementGroup<'_, '_>> = FxHashMap::default();
        for child in base.iter().flat_map(|base| &base.children) {
            groups.entry(&child.id).or_default().base.push(child);
        }
        for child in &ours.children {
            groups.entry(&child.id).or_default().ours.push(child);
        }
        for child in &theirs.children {
            groups.entry(&child.id).or_default().theirs.push(child);
        }
        let empty = ElementGroup::default();
        let group = |child: &MergeNode<'_>| groups.get(child.id.as_str()).unwrap_or(&empty);
        // New elements are inserted before conflict comments at the same place, which stay next to their elements.
        let mut places = Places::new(ours, theirs, |child| {
            let group = group(child);
            group.base.is_empty() && group.theirs.is_empty()
        });
        for (at, child) in theirs.children.iter().enumerate() {
            places.pass(at);
            let ElementGroup { base, ours, theirs } = group(child);
            let text = match (base.as_slice(), ours.as_slice(), theirs.as_slice()) {
                (_, [_, ..], _) => continue,
                ([base], [], [_]) => match self.removed_by_ours(base, child, path) {
                    Some(text) => text,
                    None => continue,
                },
                ([], [], _) if self.is_added_by_ours(child) => {
                    let path = self.path(path, child);
                    let reason = "both sides have added it, with different types".to_owned();
                    self.report(&path, reason, Ours::Elsewhere, [None, Some(child.text())])
                }
                ([], [], _) => adapted(child, places.ours.line_end, places.sibling_prefix()),
                // Several elements with one identity, which ours has all removed.
                (base, [], theirs) if theirs.first().is_some_and(|first| first.range == child.range) => {
                    if all_same(self.kind, base, theirs) {
                        continue;
                    }
                    let reason = "ours has removed the elements, and theirs has changed them".to_owned();
                    let path = self.path(path, child);
                    self.report(&path, reason, Ours::Removed, [Some(&joined(base)), Some(&joined(theirs))])
                }
                _ => continue,
            };
            places.insert(at, text);
        }
        self.edits.extend(places.edits());
        for child in &ours.children {
            let ElementGroup { base, ours, theirs } = group(child);
            match (base.as_slice(), ours.as_slice(), theirs.as_slice()) {
                (base, [ours], [theirs]) if base.len() <= 1 => {
                    self.element(ElementVersions { base: base.first().copied(), ours, theirs }, path);
                }
                ([base], [ours], []) => self.removed_by_theirs(base, ours, path),
                ([], _, []) => {}
                (base, ours, theirs) if ours.first().is_some_and(|first| first.range == child.range) => {
                    self.repeated([base, ours, theirs], path);
                }
                _ => {}
            }
        }
    }

    /// Whether ours has added data with this name in a section for a different type.
    fn is_added_by_ours(&self, theirs: &MergeNode<'_>) -> bool {
        let declares = theirs.name() == theirs.type_name.as_str();
        declares && theirs.key.as_ref().is_some_and(|name| self.added.contains(name))
    }

    fn removed_by_theirs(&mut self, base: &MergeNode<'_>, ours: &MergeNode<'_>, path: &str) {
        if same(self.kind, base, ours) {
            self.edits.push(removed(ours));
        } else if !is_default(self.kind, base) {
            let path = self.path(path, ours);
            let reason = "ours has changed it, and theirs has removed it".to_owned();
            self.conflict_at(ours, &path, reason, [Some(base.text()), None]);
        }
    }

    /// Returns the text that is inserted in ours for an element that ours has removed; `None` if theirs has not changed
    /// the element.
    fn removed_by_ours(&mut self, base: &MergeNode<'_>, theirs: &MergeNode<'_>, path: &str) -> Option<String> {
        if same(self.kind, base, theirs) {
            return None;
        }
        if is_default(self.kind, base) {
            return Some(theirs.text().to_owned());
        }
        let path = self.path(path, theirs);
        let reason = "ours has removed it, and theirs has changed it".to_owned();
        Some(self.report(&path, reason, Ours::Removed, [Some(base.text()), Some(theirs.text())]))
    }

    /// Merges indistinguishable elements as one: they must be unchanged on one side.
    fn repeated(&mut self, [base, ours, theirs]: [&[&MergeNode<'_>]; 3], path: &str) {
        if all_same(self.kind, base, theirs) || all_same(self.kind, ours, theirs) {
            return;
        }
        let Some(first) = ours.first() else { return };
        if !all_same(self.kind, base, ours) {
            let path = self.path(path, first);
            let reason = "ours and theirs differ in several elements of this name".to_owned();
            return self.conflict_at(first, &path, reason, [Some(&joined(base)), Some(&joined(theirs))]);
        }
        let texts: Vec<String> = theirs.iter().map(|node| adapted(node, first.line_end, Some(prefix(first)))).collect();
        match texts.is_empty() {
            true => self.edits.push(removed(first)),
            false => self.edit(first.range, texts.join(prefix(first))),
        }
        ours.iter().skip(1).for_each(|node| self.edits.push(removed(node)));
    }

    /// Merges a list whose order has a meaning.
    pub(crate) fn ordered(&mut self, versions: ElementVersions<'_, '_>, path: &str) {
        let ElementVersions { base, ours, theirs } = versions;
        let [b, o, t] = [base, Some(ours), Some(theirs)].map(|node| node.map(element_ids).unwrap_or_default());
        let has_additions = o.iter().chain(&t).any(|id| !b.contains(id));
        let is_clear = o == t || t == b || o == b || !has_additions;
        if is_clear && has_same_order(&t, &b) && has_same_order(&o, &b) {
            return self.children(versions, path);
        }
        match base {
            Some(base) if same(self.kind, base, ours) => self.replace(ours, theirs),
            _ if o == t => self.children(versions, path),
            _ => self.conflict(versions, path, "both sides have changed the list, whose order counts".to_owned()),
        }
    }
}

fn element_ids(node: &MergeNode<'_>) -> Vec<String> {
    node.children.iter().filter(|child| child.element.is_some()).map(|child| child.id.clone()).collect()
}

/// Whether the items that are in both lists have the same order in both.
fn has_same_order(one: &[String], other: &[String]) -> bool {
    let common = one.iter().filter(|id| other.contains(id));
    common.eq(other.iter().filter(|id| one.contains(id)))
}

fn all_same(kind: crate::kind::MergedKind, one: &[&MergeNode<'_>], other: &[&MergeNode<'_>]) -> bool {
    one.len() == other.len() && one.iter().zip(other).all(|(one, other)| same(kind, one, other))
}

fn joined(nodes: &[&MergeNode<'_>]) -> String {
    nodes.iter().map(|node| node.text()).collect::<Vec<_>>().join("\n")
}

/// Insertion places for elements of theirs among the children of ours.
struct Places<'n, 't> {
    ours: &'n MergeNode<'t>,
    theirs: &'n MergeNode<'t>,
    /// Index in ours for each child of theirs, if ours has the child.
    known: Vec<Option<usize>>,
    /// For each child of ours, the index of the last directly following child that only ours has.
    ends: Vec<usize>,
    /// Index in ours of the last passed child that both sides have.
    anchor: Option<usize>,
    edits: Vec<val3_syntax::TextEdit>,
    /// Elements for a list that is empty in ours: index in theirs, and text.
    first: Vec<(usize, String)>,
}

impl<'n, 't> Places<'n, 't> {
    fn new(
        ours: &'n MergeNode<'t>,
        theirs: &'n MergeNode<'t>,
        is_only_in_ours: impl Fn(&MergeNode<'t>) -> bool,
    ) -> Self {
        let indexes: FxHashMap<&str, usize> =
            ours.children.iter().enumerate().map(|(at, child)| (child.id.as_str(), at)).collect();
        let known = theirs.children.iter().map(|child| indexes.get(child.id.as_str()).copied()).collect();
        let mut ends: Vec<usize> = (0..ours.children.len()).collect();
        for (at, child) in ours.children.iter().enumerate().rev() {
            if let Some(end) = ends.get(at).copied().filter(|_| is_only_in_ours(child))
                && let Some(before) = at.checked_sub(1).and_then(|before| ends.get_mut(before))
            {
                *before = end;
            }
        }
        Self { ours, theirs, known, ends, anchor: None, edits: Vec::new(), first: Vec::new() }
    }

    /// Advances past a child of theirs.
    fn pass(&mut self, at: usize) {
        self.anchor = self.known.get(at).copied().flatten().or(self.anchor);
    }

    /// Returns the line end and indentation of the children in ours.
    fn sibling_prefix(&self) -> Option<&'t str> {
        self.ours.children.first().map(prefix)
    }

    /// Inserts the text for a child of theirs.
    fn insert(&mut self, at: usize, text: String) {
        let child = |at: Option<usize>| at.and_then(|at| self.ours.children.get(at));
        let anchor = self.anchor.and_then(|anchor| self.ends.get(anchor).copied());
        let following = || self.known.iter().skip(at).find_map(|known| *known);
        if let Some(anchor) = child(anchor) {
            self.edits.push(after(anchor, &text));
        } else if let Some(following) = child(following()) {
            self.edits.push(before(following, &text));
        } else if let Some(last) = self.ours.children.last() {
            self.edits.push(after(last, &text));
        } else {
            self.first.push((at, text));
        }
    }

    fn edits(mut self) -> Vec<val3_syntax::TextEdit> {
        let mut text = String::new();
        for (at, inserted) in &self.first {
            let child = self.theirs.children.get(*at).filter(|_| !text.is_empty());
            text = text + &child.map_or_else(String::new, |child| prefix_in(child, self.ours.line_end)) + inserted;
        }
        if let Some(first) = self.first.first().and_then(|(at, _)| self.theirs.children.get(*at)) {
            self.edits.extend(inside(self.ours, self.theirs, first, &text));
        }
        self.edits
    }
}
