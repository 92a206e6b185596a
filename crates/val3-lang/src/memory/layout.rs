//! Layouts of containers: addresses stay valid when array elements move, and become invalid when a key is deleted.
//!
//! Each address has the number of its container's layout. Access compares this number with the container's present
//! layout, as it would compare the generation. Only if they differ, the address is converted with [`PastLayouts`].

use super::{ContainerShape, Lanes, Place, Store};

/// Earlier layouts of a container.
#[derive(Debug, Clone)]
pub(super) struct PastLayouts {
    /// Largest layout number.
    last: u32,
    /// Layouts of an array with 2 or 3 dimensions: layout number, and sizes of the second and third dimension, which
    /// determine the lanes. Each pair of sizes has one number, so the list is as long as the number of different sizes.
    strides: Vec<(u32, [u32; 2])>,
    /// First layout in which an address of a collection's value is valid, by value number. Values beyond the end were
    /// never deleted.
    since: Vec<u32>,
}

impl Store {
    /// Returns a layout number that no address has.
    pub(super) fn next_layout(&self) -> u32 {
        self.past.as_ref().map_or(self.generation, |past| past.last).wrapping_add(1)
    }

    /// Changes the layout number after an array's sizes have changed.
    pub(super) fn note_sizes(&mut self, [_, rows, columns]: [u32; 3], [_, new_rows, new_columns]: [u32; 3]) {
        let (old, new) = ([rows, columns], [new_rows, new_columns]);
        if old == new {
            return;
        }
        let next = self.next_layout();
        let first = PastLayouts { last: self.layout, strides: vec![(self.layout, old)], since: Vec::new() };
        let past = self.past.get_or_insert_with(|| Box::new(first));
        let known = past.strides.iter().find(|(_, strides)| *strides == new).map(|(layout, _)| *layout);
        self.layout = known.unwrap_or_else(|| {
            past.strides.push((next, new));
            past.last = next;
            next
        });
    }

    /// Makes all addresses of a collection's value invalid.
    pub(super) fn note_removal(&mut self, number: u32) {
        let (next, first) = (self.next_layout(), self.generation);
        let past = PastLayouts { last: first, strides: Vec::new(), since: Vec::new() };
        let past = self.past.get_or_insert_with(|| Box::new(past));
        let at = number as usize;
        if past.since.len() <= at {
            past.since.resize(at + 1, first);
        }
        if let Some(since) = past.since.get_mut(at) {
            *since = next;
        }
        (past.last, self.layout) = (next, next);
    }

    /// Converts an address for an earlier layout of this container; `None` if the value does not exist any more.
    pub(super) fn moved(&self, at: Place) -> Option<Place> {
        if at.layout == self.layout {
            return Some(at);
        }
        let past = self.past.as_ref()?;
        let size = self.kind.size;
        let number = number_of(at.lanes(), size)?;
        let number_now = match self.shape {
            ContainerShape::Array { sizes, .. } => {
                let (_, strides) = past.strides.iter().find(|(layout, _)| *layout == at.layout)?;
                renumbered(number, *strides, sizes)?
            }
            ContainerShape::Collection(_) => {
                let since = past.since.get(number as usize).copied().unwrap_or(self.generation);
                (at.layout >= since).then_some(number)?
            }
        };
        let before = at.lanes() - size * number;
        Some(Place::in_layout(at.store, self.layout, size * number_now + before))
    }
}

/// Number of the value that contains these lanes.
fn number_of(at: Lanes, size: Lanes) -> Option<u32> {
    let lanes = [(at.num, size.num), (at.text, size.text), (at.link, size.link), (at.part, size.part)];
    lanes.into_iter().find(|(_, size)| *size > 0).map(|(at, size)| at / size)
}

/// Number of an array element after the sizes have changed; `None` if the array has no element with these indexes.
fn renumbered(number: u32, [rows, columns]: [u32; 2], new: [u32; 3]) -> Option<u32> {
    let row = number.checked_div(columns)?;
    let at = [row.checked_div(rows)?, row % rows, number % columns];
    let [_, new_rows, new_columns] = new;
    let [i, j, k] = at;
    at.iter().zip(new).all(|(index, size)| *index < size).then(|| (i * new_rows + j) * new_columns + k)
}
