//! Lists of values for each flow node, stored as one flat list.

use val3_syntax::TextSlice;

use super::FlowNodeId;

/// Any number of values for each flow node.
#[derive(Debug, Clone, PartialEq)]
pub struct PerPoint<T> {
    all: Vec<T>,
    /// End index in `all` for each flow node.
    ends: Vec<u32>,
}

impl<T> PerPoint<T> {
    /// A list without values for any node.
    pub const EMPTY: Self = Self { all: Vec::new(), ends: Vec::new() };

    /// Creates a list with capacity for `points` nodes and `values` values.
    pub fn with_capacity(points: usize, values: usize) -> Self {
        Self { all: Vec::with_capacity(values), ends: Vec::with_capacity(points) }
    }

    /// Adds the values of the next node. Call it once for each node, in the order of the graph.
    pub fn push(&mut self, values: impl IntoIterator<Item = T>) {
        self.push_with(|all| all.extend(values));
    }

    /// Like [`push`](Self::push), with a function that appends the values to the list.
    pub fn push_with(&mut self, add: impl FnOnce(&mut Vec<T>)) {
        add(&mut self.all);
        self.ends.push(u32::try_from(self.all.len()).unwrap_or(u32::MAX));
    }

    /// Releases unused capacity. Call it after the last node.
    pub fn shrink_to_fit(&mut self) {
        self.all.shrink_to_fit();
        self.ends.shrink_to_fit();
    }

    /// Returns the values of a node.
    pub fn at(&self, point: FlowNodeId) -> &[T] {
        let end = self.ends.get(point.index()).copied().unwrap_or(0);
        let start = point.index().checked_sub(1).and_then(|before| self.ends.get(before)).copied().unwrap_or(0);
        self.all.part(start as usize..end as usize)
    }

    /// Returns the values of all nodes.
    pub fn all(&self) -> &[T] {
        &self.all
    }
}
