//! What holds at each point, found by going round until nothing changes.

use super::{Flow, Point, PointId};

/// What holds before each point; `None` where no way leads there.
#[derive(Debug, Clone, PartialEq)]
pub struct Facts<S>(Vec<Option<S>>);

impl<S> Facts<S> {
    /// What holds when the point is reached; `None` if it never is.
    pub fn before(&self, point: PointId) -> Option<&S> {
        self.0.get(point.index())?.as_ref()
    }
}

/// Solves a forward problem: `start` holds at the beginning, `step` says what holds behind a point, and `join` adds
/// what holds on another way and tells whether that was news.
///
/// `join` must only ever add, and there must be an end to what can be added; then this ends as well.
pub fn forward<S: Clone>(
    flow: &Flow,
    start: S,
    mut step: impl FnMut(&Point, &S) -> S,
    mut join: impl FnMut(&mut S, &S) -> bool,
) -> Facts<S> {
    let mut facts: Vec<Option<S>> = vec![None; flow.len()];
    let mut open = vec![Flow::START];
    if let Some(slot) = facts.first_mut() {
        *slot = Some(start);
    }
    while let Some(id) = open.pop() {
        let (Some(point), Some(Some(before))) = (flow.point(id), facts.get(id.index())) else { continue };
        let after = step(point, before);
        for next in &point.next {
            let Some(slot) = facts.get_mut(next.index()) else { continue };
            let news = match slot {
                Some(known) => join(known, &after),
                None => {
                    *slot = Some(after.clone());
                    true
                }
            };
            if news {
                open.push(*next);
            }
        }
    }
    Facts(facts)
}
