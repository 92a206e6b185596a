//! The stack of a task: the consecutive frames of the programs that it executes.

use super::{Lanes, Link, Place, StoreId, View, bytes_of};
use crate::values::Text;

/// The lanes of all frames.
#[derive(Debug, Clone, Default)]
pub struct Stack {
    /// Numbers, truth values and enumerators.
    pub nums: Vec<f64>,
    /// Texts.
    pub texts: Vec<Text>,
    /// Links.
    pub links: Vec<Link>,
    /// Local arrays, and the fields of local values of user types.
    pub parts: Vec<StoreId>,
    /// Parameters by reference, and elements that the code looks up.
    pub places: Vec<Place>,
    /// Containers by reference, and those that the code looks up.
    pub views: Vec<View>,
}

impl Stack {
    /// The lanes that are in use or were.
    #[must_use]
    pub fn ends(&self) -> Lanes {
        Lanes {
            num: count(self.nums.len()),
            text: count(self.texts.len()),
            link: count(self.links.len()),
            part: count(self.parts.len()),
        }
    }

    /// The bytes of its lanes.
    #[must_use]
    pub fn bytes(&self) -> u64 {
        self.ends().bytes() + bytes_of::<Place>(self.places.len()) + bytes_of::<View>(self.views.len())
    }

    /// Removes what begins at these lanes, places and views. Returns the bytes that it took.
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

    /// Cuts off what begins at these lanes, places and views, as a stack of its own.
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
