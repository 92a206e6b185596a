//! Arrays in data files: their sizes, and their elements by index.

use rustc_hash::FxHashMap;

use crate::kind::{DECLARATION, MergedKind};
use crate::node::MergeNode;
use crate::same::same_value;

/// Container of values in one version of a file.
pub(crate) struct Array<'n, 't> {
    /// Sizes of the dimensions; `None` for a collection.
    pub(crate) sizes: Option<Vec<usize>>,
    elements: FxHashMap<Vec<usize>, &'n MergeNode<'t>>,
}

/// Whether an element at this depth declares values: `Data`, `Field`, or a variable of s5 and s6.
pub(crate) fn is_container(node: &MergeNode<'_>, depth: usize) -> bool {
    node.key.is_some() && (matches!(node.name(), "Data" | "Field") || depth == DECLARATION)
}

impl<'n, 't> Array<'n, 't> {
    pub(crate) fn of(node: &'n MergeNode<'t>) -> Self {
        let elements: FxHashMap<_, _> = values(node).filter_map(|value| Some((index_of(value)?, value))).collect();
        let sizes = match (node.value("xsi:type").as_deref(), node.value("size")) {
            (Some("collection"), _) => None,
            (_, Some(size)) => numbers(&size, ' '),
            // A file of s5 or s6 contains all values instead of the size.
            (_, None) => Some(vec![elements.keys().filter_map(|index| index.first()).max().map_or(1, |last| last + 1)]),
        };
        Self { sizes, elements }
    }

    /// Returns the number of elements in one dimension.
    pub(crate) fn size(&self, axis: usize) -> usize {
        self.sizes.as_ref().and_then(|sizes| sizes.get(axis)).copied().unwrap_or(0)
    }

    /// Returns the element at `index` of a one-dimensional array.
    pub(crate) fn at(&self, index: usize) -> Option<&'n MergeNode<'t>> {
        self.elements.get(&[index][..]).copied()
    }

    /// Returns the first index at which the arrays differ, at most the smaller size.
    pub(crate) fn first_difference(&self, kind: MergedKind, other: &Self) -> usize {
        let common = self.size(0).min(other.size(0));
        let differs = |index: &usize| !same_value(kind, self.at(*index), other.at(*index));
        (0..common).find(differs).unwrap_or(common)
    }

    /// Whether an element with a wanted index differs.
    pub(crate) fn differs_where(&self, kind: MergedKind, other: &Self, is_wanted: impl Fn(&[usize]) -> bool) -> bool {
        let mut indexes = self.elements.keys().chain(other.elements.keys()).filter(|index| is_wanted(index));
        indexes.any(|index| !same_value(kind, self.elements.get(index).copied(), other.elements.get(index).copied()))
    }

    /// Whether an element from `start` on differs.
    pub(crate) fn differs_from(&self, kind: MergedKind, other: &Self, start: usize) -> bool {
        self.differs_where(kind, other, |index| index.len() != 1 || index.first().is_some_and(|index| *index >= start))
    }

    /// Whether it is an array of one dimension.
    pub(crate) fn is_list(&self) -> bool {
        self.sizes.as_ref().is_some_and(|sizes| sizes.len() == 1)
    }

    /// Whether elements were inserted before the last elements of `base`, which moved to higher indexes.
    pub(crate) fn is_shifted(&self, kind: MergedKind, base: &Self) -> bool {
        if !self.is_list() || !base.is_list() {
            return false;
        }
        let Some(by) = self.size(0).checked_sub(base.size(0)).filter(|by| *by > 0) else {
            return false;
        };
        let first = self.first_difference(kind, base);
        let moved = |index: usize| same_element(kind, base.at(index), self.at(index + by));
        first < base.size(0) && (first..base.size(0)).all(moved)
    }
}

/// Returns the elements of a variable or field.
pub(crate) fn values<'n, 't>(node: &'n MergeNode<'t>) -> impl Iterator<Item = &'n MergeNode<'t>> {
    node.children.iter().filter(|child| child.name().to_ascii_lowercase().starts_with("value"))
}

/// Parses an element's index: `7`, `2,1`.
pub(crate) fn index_of(value: &MergeNode<'_>) -> Option<Vec<usize>> {
    numbers(value.key.as_deref()?, ',')
}

fn numbers(text: &str, separator: char) -> Option<Vec<usize>> {
    let words = text.split(separator).map(str::trim).filter(|word| !word.is_empty());
    let numbers: Option<Vec<usize>> = words.map(|word| word.parse().ok()).collect();
    numbers.filter(|numbers| !numbers.is_empty())
}

/// Whether two elements are equal except for their indexes.
pub(crate) fn same_element(kind: MergedKind, one: Option<&MergeNode<'_>>, other: Option<&MergeNode<'_>>) -> bool {
    match (one, other) {
        (Some(one), Some(other)) => crate::same::same_content(kind, one, other),
        (one, other) => same_value(kind, one, other),
    }
}
