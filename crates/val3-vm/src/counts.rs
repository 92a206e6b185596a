//! Execution counts of lines and of branch sides, for images that were compiled with counters.

use std::sync::Arc;

use val3_bytecode::{Image, Program};

/// Counters of all images that are or were in memory; empty without counted images.
#[derive(Debug, Clone, Default)]
pub struct LineCounts {
    hits: Vec<u64>,
    /// Counted images with the numbers of their first counters. An unloaded library keeps its counters.
    images: Vec<(Arc<Image>, u32)>,
}

impl LineCounts {
    /// Returns the number of the image's first counter. An image that is loaded again continues with its counters.
    pub(crate) fn first_of(&mut self, image: &Arc<Image>) -> u32 {
        if let Some((_, first)) = self.images.iter().find(|(known, _)| Arc::ptr_eq(known, image)) {
            return *first;
        }
        let (first, count) = (u32::try_from(self.hits.len()).unwrap_or(u32::MAX), image.counters());
        if count > 0 {
            self.hits.resize(self.hits.len().saturating_add(count as usize), 0);
            self.images.push((Arc::clone(image), first));
        }
        first
    }

    /// Counts an execution.
    #[inline]
    pub(crate) fn add(&mut self, first: u32, program: &Program, counter: u16) {
        let at = first as usize + program.counters.first as usize + usize::from(counter);
        if let Some(hits) = self.hits.get_mut(at) {
            *hits += 1;
        }
    }

    /// Returns the counted images and their counters.
    pub fn images(&self) -> impl Iterator<Item = (&Image, &[u64])> {
        self.images.iter().map(|(image, first)| {
            let (first, count) = (*first as usize, image.counters() as usize);
            let hits = self.hits.get(first..first.saturating_add(count)).unwrap_or_default();
            (&**image, hits)
        })
    }
}
