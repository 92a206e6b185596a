//! Values that belong to the points of a flow graph, in one list.

use val3_syntax::Part;

use super::PointId;

/// Any number of values for each point.
#[derive(Debug, Clone, PartialEq)]
pub struct PerPoint<T> {
    all: Vec<T>,
    /// Where in `all` the values of each point end.
    ends: Vec<u32>,
}

impl<T> PerPoint<T> {
    /// Nothing for any point.
    pub const EMPTY: Self = Self { all: Vec::new(), ends: Vec::new() };

    /// Room for `values` of `points`.
    pub fn with_capacity(points: usize, values: usize) -> Self {
        Self { all: Vec::with_capacity(values), ends: Vec::with_capacity(points) }
    }

    /// Adds the values of the next point; every point must get its turn, in the order of the graph.
    pub fn push(&mut self, values: impl IntoIterator<Item = T>) {
        self.push_with(|all| all.extend(values));
    }

    /// As [`push`](Self::push), with a function that adds the values to the end of the list.
    pub fn push_with(&mut self, add: impl FnOnce(&mut Vec<T>)) {
        add(&mut self.all);
        self.ends.push(u32::try_from(self.all.len()).unwrap_or(u32::MAX));
    }

    /// Gives back what is not used; every point had its turn.
    pub fn shrink_to_fit(&mut self) {
        self.all.shrink_to_fit();
        self.ends.shrink_to_fit();
    }

    /// The values of a point.
    pub fn at(&self, point: PointId) -> &[T] {
        let end = self.ends.get(point.index()).copied().unwrap_or(0);
        let start = point.index().checked_sub(1).and_then(|before| self.ends.get(before)).copied().unwrap_or(0);
        self.all.part(start as usize..end as usize)
    }

    /// The values of all points.
    pub fn all(&self) -> &[T] {
        &self.all
    }
}
