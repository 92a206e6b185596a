//! Array elements after a change of the dimensions (2.5.5).

use super::{ContainerShape, Lanes, Store, StoreId};

impl Store {
    /// Moves the elements from an array of size `old` to an array of size `new`. New elements get their inner
    /// containers from `fresh`. Returns the inner containers of removed elements.
    pub(super) fn rearrange(
        &mut self,
        old: [u32; 3],
        new: [u32; 3],
        shape: ContainerShape,
        fresh: Vec<StoreId>,
    ) -> Vec<StoreId> {
        let size = self.kind.size;
        let mut target = Self { parts: Vec::new(), ..Self::filled(self.kind.clone(), shape) };
        let (mut kept, mut fresh) = (vec![false; self.parts.len()], fresh.into_iter());
        for at in indexes(new) {
            if at.iter().zip(old).all(|(index, size)| *index < size) {
                let (from, to) = (size * number(at, old), size * number(at, new));
                move_lanes(self, from, &mut target, to, size);
                let parts = from.part as usize..(from.part + size.part) as usize;
                target.parts.extend_from_slice(self.parts.get(parts.clone()).unwrap_or_default());
                kept.get_mut(parts).unwrap_or_default().fill(true);
            } else {
                target.parts.extend(fresh.by_ref().take(size.part as usize));
            }
        }
        self.exchange(&mut target);
        self.note_sizes(old, new);
        target.parts.into_iter().zip(kept).filter(|(_, kept)| !kept).map(|(part, _)| part).collect()
    }
}

fn indexes([x, y, z]: [u32; 3]) -> impl Iterator<Item = [u32; 3]> {
    (0..x).flat_map(move |i| (0..y).flat_map(move |j| (0..z).map(move |k| [i, j, k])))
}

fn number([i, j, k]: [u32; 3], [_, y, z]: [u32; 3]) -> u32 {
    (i * y + j) * z + k
}

fn move_lanes(source: &Store, from: Lanes, target: &mut Store, to: Lanes, size: Lanes) {
    fn lane<T: Copy>(source: &[T], from: u32, target: &mut [T], to: u32, size: u32) {
        let range = |at: u32| at as usize..(at + size) as usize;
        if let (Some(source), Some(target)) = (source.get(range(from)), target.get_mut(range(to))) {
            target.copy_from_slice(source);
        }
    }
    lane(&source.nums, from.num, &mut target.nums, to.num, size.num);
    lane(&source.texts, from.text, &mut target.texts, to.text, size.text);
    lane(&source.links, from.link, &mut target.links, to.link, size.link);
}
