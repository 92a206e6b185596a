//! Plans for merging variables that both sides have changed.

use rustc_hash::FxHashMap;

use crate::array::{Array, is_container, same_element, values};
use crate::kind::MergedKind;
use crate::node::MergeNode;
use crate::same::{has_defaults, same};

/// Plan for merging one variable or field.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(crate) enum Plan {
    /// Both sides have appended elements: the elements of theirs follow the elements of ours.
    Append(Append),
    /// Theirs replaces ours, whose values are unchanged since the base.
    Replace,
    /// The variable cannot be merged by index, for this reason.
    Conflict(&'static str),
}

impl Plan {
    /// Returns the appended elements.
    pub(crate) fn append(&self) -> Option<&Append> {
        if let Self::Append(append) = self { Some(append) } else { None }
    }
}

/// Elements of theirs that move to other indexes.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(crate) struct Append {
    /// Data path of the variable or field, with the indexes of theirs, for example `tSlot[1].pPick`.
    pub(crate) path: String,
    /// Extended dimension, from 0.
    pub(crate) axis: usize,
    /// First index of theirs that changes.
    pub(crate) from: usize,
    /// Number that is added to the index.
    pub(crate) by: usize,
    /// Number of moved elements.
    pub(crate) count: usize,
    /// Size in the merged file.
    pub(crate) size: usize,
}

/// Plans of variables and fields, by data path. Variables without a plan are merged by index or key.
pub(crate) type Plans = FxHashMap<String, Plan>;

/// Plans the merge of a data file.
pub(crate) fn plans(base: &MergeNode<'_>, ours: &MergeNode<'_>, theirs: &MergeNode<'_>) -> Plans {
    let mut planner = Planner(Plans::default());
    planner.nodes([base, ours, theirs], 0, "");
    planner.0
}

/// Returns the data path of a variable, value or field in an element with the path `around`.
pub(crate) fn path_of(around: &str, node: &MergeNode<'_>) -> String {
    match (node.name(), node.key.as_deref()) {
        (_, None) => around.to_owned(),
        ("Field", Some(name)) => format!("{around}.{name}"),
        (name, Some(key)) if name.to_ascii_lowercase().starts_with("value") => format!("{around}[{key}]"),
        (_, Some(name)) => name.to_owned(),
    }
}

struct Planner(Plans);

impl Planner {
    /// Plans the content of elements that are in all three versions.
    fn nodes(&mut self, [base, ours, theirs]: [&MergeNode<'_>; 3], depth: usize, around: &str) {
        let [in_base, in_theirs] = [base, theirs].map(by_id);
        for ours in ours.children.iter().filter(|child| child.element.is_some()) {
            let (Some(base), Some(theirs)) = (in_base.get(ours.id.as_str()), in_theirs.get(ours.id.as_str())) else {
                continue;
            };
            let path = path_of(around, ours);
            // The children of the file have depth 0.
            if is_container(ours, depth) {
                self.container([base, ours, theirs], depth, &path);
            } else {
                self.nodes([base, ours, theirs], depth + 1, &path);
            }
        }
    }

    fn container(&mut self, nodes: [&MergeNode<'_>; 3], depth: usize, path: &str) {
        let [base, ours, theirs] = nodes;
        let kind = MergedKind::Data;
        if same(kind, base, theirs) || same(kind, base, ours) || same(kind, ours, theirs) {
            // A change on one side needs no plan, except a change of the type, because the old values are invalid then.
            if same(kind, base, ours) && shape(base) != shape(theirs) {
                self.0.insert(path.to_owned(), Plan::Replace);
            }
            return;
        }
        match plan(nodes, path) {
            Some(plan) => {
                let is_append = matches!(plan, Plan::Append(_));
                self.0.insert(path.to_owned(), plan);
                if is_append {
                    self.nodes(nodes, depth + 1, path);
                }
            }
            None => self.nodes(nodes, depth + 1, path),
        }
    }
}

fn by_id<'n, 't>(node: &'n MergeNode<'t>) -> FxHashMap<&'n str, &'n MergeNode<'t>> {
    node.children.iter().map(|child| (child.id.as_str(), child)).collect()
}

/// Returns the type, the container and the number of dimensions.
fn shape(node: &MergeNode<'_>) -> (String, Option<String>, Option<usize>) {
    (node.type_name.to_string(), node.value("xsi:type"), Array::of(node).sizes.map(|sizes| sizes.len()))
}

fn plan([base, ours, theirs]: [&MergeNode<'_>; 3], path: &str) -> Option<Plan> {
    let kind = MergedKind::Data;
    let [b, o, t] = [base, ours, theirs].map(Array::of);
    if shape(base) != shape(ours) || shape(base) != shape(theirs) {
        let is_same = shape(ours) == shape(theirs) && o.sizes == t.sizes;
        return (!is_same).then_some(Plan::Conflict("one side has changed the type, and the other one the values"));
    }
    let (Some(base_sizes), Some(our_sizes), Some(their_sizes)) = (&b.sizes, &o.sizes, &t.sizes) else { return None };
    match (base_sizes == our_sizes, base_sizes == their_sizes) {
        (true, true) => None,
        (false, true) => one_sided(&b, &o, &t),
        (true, false) => one_sided(&b, &t, &o),
        (false, false) => {
            let appended = [&o, &t].into_iter().all(|side| !side.is_shifted(kind, &b));
            match common_axis(base_sizes, our_sizes, their_sizes).filter(|_| appended) {
                Some(axis) => append(&b, &o, &t, axis, path),
                None if our_sizes == their_sizes => by_index(&b, &o, &t),
                None => Some(Plan::Conflict("both sides have changed the size")),
            }
        }
    }
}

/// Plans a variable whose size only `changed` has changed; `other` has the size of the base.
fn one_sided(base: &Array<'_, '_>, changed: &Array<'_, '_>, other: &Array<'_, '_>) -> Option<Plan> {
    let kind = MergedKind::Data;
    let sizes = |array: &Array<'_, '_>| array.sizes.clone().unwrap_or_default();
    let grows = sizes(base).iter().zip(sizes(changed)).all(|(base, changed)| *base <= changed);
    if grows && !changed.is_shifted(kind, base) {
        return None;
    }
    let is_list = sizes(base).len() == 1;
    let start = if is_list { changed.first_difference(kind, base) } else { 0 };
    let reason = "one side has inserted or removed elements, and the other one has changed elements after them";
    other.differs_from(kind, base, start).then_some(Plan::Conflict(reason))
}

/// Plans a variable with the same new size on both sides: elements keep their indexes if no side has moved any.
fn by_index(base: &Array<'_, '_>, ours: &Array<'_, '_>, theirs: &Array<'_, '_>) -> Option<Plan> {
    let is_list = base.is_list();
    let start = if is_list {
        let first = |side: &Array<'_, '_>| side.first_difference(MergedKind::Data, base);
        first(ours).min(first(theirs))
    } else {
        0
    };
    let reason = "both sides have inserted or removed elements";
    ours.differs_from(MergedKind::Data, theirs, start).then_some(Plan::Conflict(reason))
}

/// Returns the dimension that both sides have extended, if all other dimensions are unchanged.
fn common_axis(base: &[usize], ours: &[usize], theirs: &[usize]) -> Option<usize> {
    let mut changed = (0..base.len()).filter(|axis| {
        let size = base.get(*axis);
        size != ours.get(*axis) || size != theirs.get(*axis)
    });
    let axis = changed.next().filter(|axis| base.get(*axis) < ours.get(*axis) && base.get(*axis) < theirs.get(*axis));
    axis.filter(|_| changed.next().is_none())
}

fn append(base: &Array<'_, '_>, ours: &Array<'_, '_>, theirs: &Array<'_, '_>, axis: usize, path: &str) -> Option<Plan> {
    let (first, our_size, their_size) = (base.size(axis), ours.size(axis), theirs.size(axis));
    if our_size == their_size && !ours.differs_after(theirs, axis, first) {
        return None;
    }
    let is_list = base.is_list();
    let common = first..our_size.min(their_size);
    let shared = if is_list { common.take_while(|index| is_added_by_both(ours, theirs, *index)).count() } else { 0 };
    let from = first + shared;
    let count = their_size - from;
    Some(Plan::Append(Append { path: path.to_owned(), axis, from, by: our_size - from, count, size: our_size + count }))
}

/// Whether both sides have equal elements at `index`, which are one change that was made on both sides. Two elements
/// with default values may be different elements.
fn is_added_by_both(ours: &Array<'_, '_>, theirs: &Array<'_, '_>, index: usize) -> bool {
    let is_written = ours.at(index).is_some_and(|element| !has_defaults(element, &["fatherId"]));
    is_written && same_element(MergedKind::Data, ours.at(index), theirs.at(index))
}

impl Array<'_, '_> {
    /// Whether an element with an index from `start` on in the dimension `axis` differs.
    fn differs_after(&self, other: &Self, axis: usize, start: usize) -> bool {
        self.differs_where(MergedKind::Data, other, |index| index.get(axis).is_some_and(|index| *index >= start))
    }
}

/// Returns the elements of theirs that move, with their new indexes.
pub(crate) fn moved<'n, 't>(theirs: &'n MergeNode<'t>, append: &Append) -> Vec<(&'n MergeNode<'t>, Vec<usize>)> {
    let found = values(theirs).filter_map(|value| {
        let mut index = crate::array::index_of(value)?;
        let at = index.get_mut(append.axis).filter(|at| **at >= append.from)?;
        *at += append.by;
        Some((value, index))
    });
    found.collect()
}
