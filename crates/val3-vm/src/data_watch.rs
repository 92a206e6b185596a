//! Watched values, which the interpreter compares after each line: a turn ends after a line that has changed one.

use val3_lang::memory::{ContainerShape, Lanes, LinkPlace, Memory, Place, StoreId};
use val3_lang::ports::TaskNumber;
use val3_lang::values::Text;

use crate::Frame;

/// Values whose changes a cycle [reports](crate::CycleWatch::Changes).
#[derive(Debug, Clone, Default)]
pub struct DataWatch(Vec<WatchedValue>);

/// Numbers, strings and links at one place in memory, with the values of the last comparison.
#[derive(Debug, Clone)]
pub struct WatchedValue {
    /// Stack frame of a local variable or parameter; `None` for global data.
    pub owner: Option<FrameOwner>,
    /// Container with its shape; `None` for a value on the stack.
    pub container: Option<(StoreId, ContainerShape)>,
    /// Place of the first number, string and link.
    pub place: Place,
    /// Numbers, bit by bit.
    pub bits: Vec<u64>,
    /// Strings.
    pub texts: Vec<Text>,
    /// Links, for example the frame of a point.
    pub links: Vec<LinkPlace>,
}

/// A stack frame of a task. Only this task changes the values on its stack.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct FrameOwner {
    /// Task.
    pub task: TaskNumber,
    /// Index of the frame, from the outermost one.
    pub index: usize,
    /// The frame.
    pub frame: Frame,
}

/// Line that a turn has begun: stack frame and first operation.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct BegunLine {
    /// Innermost stack frame at the beginning of the line.
    pub frame: Frame,
    /// First operation; at the beginning of a turn within a line the next one.
    pub op: u32,
}

impl FromIterator<WatchedValue> for DataWatch {
    fn from_iter<T: IntoIterator<Item = WatchedValue>>(values: T) -> Self {
        Self(values.into_iter().collect())
    }
}

impl DataWatch {
    /// Whether a value has changed or no longer exists. The memory contains the stack of `task`.
    pub(crate) fn has_changed(&self, memory: &Memory, task: TaskNumber, frames: &[Frame]) -> bool {
        self.0.iter().any(|value| value.has_changed(memory, task, frames))
    }
}

impl WatchedValue {
    fn has_changed(&self, memory: &Memory, task: TaskNumber, frames: &[Frame]) -> bool {
        match &self.owner {
            Some(owner) if owner.task == task && frames.get(owner.index) != Some(&owner.frame) => true,
            Some(owner) if owner.task != task && self.container.is_none() => false,
            _ => !self.is_same(memory),
        }
    }

    fn is_same(&self, memory: &Memory) -> bool {
        let has_shape = self.container.as_ref().is_none_or(|(id, shape)| match memory.store(*id) {
            Ok(store) => store.shape == *shape,
            Err(_) => false,
        });
        let mut bits = (0..).zip(&self.bits);
        let mut texts = (0..).zip(&self.texts);
        let mut links = (0..).zip(&self.links);
        has_shape
            && bits.all(|(lane, bits)| memory.num(self.place, lane).is_ok_and(|number| number.to_bits() == *bits))
            && texts.all(|(lane, seen)| memory.text(self.place.after(Lanes::texts(lane))).is_ok_and(|now| now == seen))
            && links.all(|(lane, seen)| memory.link(self.place, lane).is_ok_and(|now| now == *seen))
    }
}
