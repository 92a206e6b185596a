//! Stack of a task: the consecutive frames of the programs in execution.

use super::{Lanes, LinkPlace, Place, StoreId, View, bytes_of};
use crate::values::Text;

/// Lanes of all frames.
#[derive(Debug, Clone, Default)]
pub struct Stack {
    /// Numbers, truth values and enumerators.
    pub nums: Vec<f64>,
    /// Strings.
    pub texts: Vec<Text>,
    /// Links.
    pub links: Vec<LinkPlace>,
    /// Local arrays, and fields of local values of user types.
    pub parts: Vec<StoreId>,
    /// Parameters by reference, and addresses computed by the code.
    pub places: Vec<Place>,
    /// Containers by reference, and views computed by the code.
    pub views: Vec<View>,
}

impl Stack {
    /// Allocated lanes.
    #[must_use]
    pub fn ends(&self) -> Lanes {
        Lanes {
            num: count(self.nums.len()),
            text: count(self.texts.len()),
            link: count(self.links.len()),
            part: count(self.parts.len()),
        }
    }

    /// Size in bytes.
    #[must_use]
    pub fn bytes(&self) -> u64 {
        self.ends().bytes() + bytes_of::<Place>(self.places.len()) + bytes_of::<View>(self.views.len())
    }

    /// Removes everything from these lanes, places and views on. Returns the released size in bytes.
    pub fn truncate(&mut self, lanes: Lanes, places: u32, views: u32) -> u64 {
        let before = self.bytes();
        self.nums.truncate(lanes.num as usize);
        self.texts.truncate(lanes.text as usize);
        self.links.truncate(lanes.link as usize);
        self.parts.truncate(lanes.part as usize);
        self.places.truncate(places as usize);
        self.views.truncate(views as usize);
        before - self.bytes()
    }

    /// Moves everything from these lanes, places and views on to a new stack.
    #[must_use]
    pub fn split_off(&mut self, lanes: Lanes, places: u32, views: u32) -> Self {
        Self {
            nums: cut(&mut self.nums, lanes.num),
            texts: cut(&mut self.texts, lanes.text),
            links: cut(&mut self.links, lanes.link),
            parts: cut(&mut self.parts, lanes.part),
            places: cut(&mut self.places, places),
            views: cut(&mut self.views, views),
        }
    }
}

fn count(len: usize) -> u32 {
    u32::try_from(len).unwrap_or(u32::MAX)
}

fn cut<T>(lanes: &mut Vec<T>, at: u32) -> Vec<T> {
    lanes.split_off(lanes.len().min(at as usize))
}
