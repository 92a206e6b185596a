//! A container with its values.

use std::sync::Arc;

use super::layout::PastLayouts;
use super::{ContainerShape, DetachedValue, Lanes, LinkPlace, PartInit, Place, StoreId, ValueType, View, bytes_of};
use crate::fault::{Fault, Result};
use crate::values::Text;
use crate::values::numbers::BELOW_HALF;

/// Size of a container without its values and keys, in bytes.
const STORE_BYTES: u64 = bytes_of::<Store>(1);

/// A container: its layout, and its values as lanes.
///
/// Value `n` starts at lane `n * kind.size`. Removing a value from a collection leaves a gap, which the next insertion
/// fills. All other values keep their lanes. References to a removed value become invalid, and references to values
/// that moved stay valid (see [`PastLayouts`]).
#[derive(Debug, Clone)]
pub struct Store {
    pub(super) generation: u32,
    /// Type of the values.
    pub kind: Arc<ValueType>,
    /// Layout.
    pub shape: ContainerShape,
    /// Owner, which determines what may refer to the container. A local container cannot grow or shrink (2.5.4).
    pub owner: Owner,
    /// Whether it is a field of a user type's value. Such a container can grow and shrink even if it is local (7.3).
    pub(super) field: bool,
    pub(super) gaps: Vec<u32>,
    /// Number of the present layout, unique among all containers that had this index in memory.
    pub(super) layout: u32,
    /// Earlier layouts, if there are any.
    pub(super) past: Option<Box<PastLayouts>>,
    /// Numbers.
    pub nums: Vec<f64>,
    /// Strings.
    pub texts: Vec<Text>,
    /// Links.
    pub links: Vec<LinkPlace>,
    /// Inner containers.
    pub parts: Vec<StoreId>,
}

impl Store {
    /// Creates a container with default values of a built-in type. For user types, use
    /// [`Memory::create`](super::Memory::create).
    pub(super) fn filled(kind: Arc<ValueType>, shape: ContainerShape) -> Self {
        let count = shape.len() as usize;
        Self {
            generation: 0,
            nums: repeated(&kind.default.nums, count),
            texts: vec![Text::default(); kind.default.texts.len() * count],
            links: kind.default.links.repeat(count),
            parts: Vec::new(),
            kind,
            shape,
            owner: Owner::Controller,
            field: false,
            gaps: Vec::new(),
            layout: 0,
            past: None,
        }
    }

    /// Starts a new life with this generation, without earlier layouts.
    pub(super) fn begin(&mut self, generation: u32) {
        (self.generation, self.layout, self.past) = (generation, generation, None);
    }

    /// Size in bytes, without inner containers. A gap counts as a value.
    pub(super) fn bytes(&self) -> u64 {
        let Self { nums, texts, links, parts, .. } = self;
        let lanes = bytes_of::<f64>(nums.len())
            + bytes_of::<Text>(texts.len())
            + bytes_of::<LinkPlace>(links.len())
            + bytes_of::<StoreId>(parts.len());
        STORE_BYTES + self.shape.key_bytes() + lanes
    }

    /// Exchanges the values, but not type, owner and layout number.
    pub(super) fn exchange(&mut self, other: &mut Self) {
        std::mem::swap(&mut self.shape, &mut other.shape);
        std::mem::swap(&mut self.gaps, &mut other.gaps);
        std::mem::swap(&mut self.nums, &mut other.nums);
        std::mem::swap(&mut self.texts, &mut other.texts);
        std::mem::swap(&mut self.links, &mut other.links);
        std::mem::swap(&mut self.parts, &mut other.parts);
    }

    /// Copies another array's values in place, if type and sizes are equal. Returns `false` for other containers.
    pub(super) fn overwrite(&mut self, from: &Self) -> bool {
        let alike = match (&self.shape, &from.shape) {
            (ContainerShape::Array { sizes, .. }, ContainerShape::Array { sizes: others, .. }) => sizes == others,
            _ => false,
        };
        let alike = alike && from.parts.is_empty() && self.kind.size == from.kind.size;
        if alike {
            self.nums.copy_from_slice(&from.nums);
            self.texts.copy_from_slice(&from.texts);
            self.links.copy_from_slice(&from.links);
        }
        alike
    }

    /// Removes the container. Its new generation invalidates all references. Returns the inner containers.
    pub(super) fn empty(&mut self) -> Vec<StoreId> {
        self.begin(self.next_layout());
        self.shape = ContainerShape::array(0);
        self.owner = Owner::Controller;
        self.gaps = Vec::new();
        (self.nums, self.texts, self.links) = (Vec::new(), Vec::new(), Vec::new());
        std::mem::take(&mut self.parts)
    }

    /// Whether the container has a value with this number.
    #[inline]
    pub(super) fn has_value(&self, number: u32) -> bool {
        match &self.shape {
            ContainerShape::Array { .. } => number < self.shape.len(),
            ContainerShape::Collection(keys) => {
                (number as usize) < keys.len() + self.gaps.len() && !self.gaps.contains(&number)
            }
        }
    }

    /// Address of a value by its number in the container.
    #[must_use]
    #[inline]
    pub fn place(&self, id: StoreId, number: u32) -> Place {
        Place::in_layout(id, self.layout, self.kind.size * number)
    }

    /// Number of a one-dimensional array's element at an index, which is rounded (2.5.3).
    ///
    /// # Errors
    /// 21 below zero, 20 beyond the size.
    #[inline]
    pub fn number1(&self, view: View, index: f64) -> Result<u32> {
        match self.shape {
            ContainerShape::Array { dims: 1, sizes: [size, ..] } => {
                within(index, size.saturating_sub(view.start)).map(|at| at + view.start)
            }
            _ => Err(Fault::INDEX_TOO_LARGE),
        }
    }

    /// Number of a two-dimensional array's element.
    ///
    /// # Errors
    /// 21 below zero, 20 beyond the size.
    #[inline]
    pub fn number2(&self, [i, j]: [f64; 2]) -> Result<u32> {
        match self.shape {
            ContainerShape::Array { dims: 2, sizes: [rows, columns, _] } => {
                Ok(within(i, rows)? * columns + within(j, columns)?)
            }
            _ => Err(Fault::INDEX_TOO_LARGE),
        }
    }

    /// Lane of an element in a one-dimensional number array. Each element has one lane, so an index beyond the size is
    /// a lane beyond `nums`.
    #[inline(always)]
    pub(super) fn lane1(&self, view: View, index: f64) -> Option<usize> {
        match self.shape {
            ContainerShape::Array { dims: 1, .. } => Some(view.start as usize + rounded(index)? as usize),
            _ => None,
        }
    }

    /// As [`lane1`](Self::lane1), in a two-dimensional array.
    #[inline(always)]
    pub(super) fn lane2(&self, [i, j]: [f64; 2]) -> Option<usize> {
        match self.shape {
            ContainerShape::Array { dims: 2, sizes: [_, columns, _] } => {
                let (i, j) = (rounded(i)?, rounded(j)?);
                (j < columns).then_some(i as usize * columns as usize + j as usize)
            }
            _ => None,
        }
    }

    /// Number of a three-dimensional array's element.
    ///
    /// # Errors
    /// 21 below zero, 20 beyond the size.
    pub fn number3(&self, [i, j, k]: [f64; 3]) -> Result<u32> {
        match self.shape {
            ContainerShape::Array { dims: 3, sizes: [x, y, z] } => {
                Ok((within(i, x)? * y + within(j, y)?) * z + within(k, z)?)
            }
            _ => Err(Fault::INDEX_TOO_LARGE),
        }
    }

    /// Number of the element under a key.
    ///
    /// # Errors
    /// 20 if the key does not exist.
    pub fn number_of(&self, key: &Text) -> Result<u32> {
        match &self.shape {
            ContainerShape::Collection(keys) => keys.get(key).copied().ok_or(Fault::INDEX_TOO_LARGE),
            ContainerShape::Array { .. } => Err(Fault::INDEX_TOO_LARGE),
        }
    }

    /// Number of the element with this subscript in a data file: `3`, `1,2`, `home`.
    #[must_use]
    pub fn number_of_text(&self, at: &str) -> Option<u32> {
        self.shape.number_of_text(at)
    }

    /// Appends the lanes of a default value. For a user type, the inner containers are not appended.
    pub(super) fn push_default(&mut self) {
        let DetachedValue { nums, texts, links, .. } = &self.kind.default;
        self.nums.extend_from_slice(nums);
        self.texts.extend_from_slice(texts);
        self.links.extend_from_slice(links);
    }
}

impl ContainerShape {
    /// Size of a container with this layout and values of this size, in bytes, without inner containers.
    #[must_use]
    pub fn bytes(&self, size: Lanes) -> u64 {
        STORE_BYTES.saturating_add(self.key_bytes()).saturating_add(size.bytes().saturating_mul(self.len().into()))
    }
}

impl PartInit {
    /// Size of the container and its inner containers in bytes, including the stored initial values.
    #[must_use]
    pub fn bytes(&self) -> u64 {
        let sum = |parts: &[Self]| parts.iter().map(Self::bytes).fold(0, u64::saturating_add);
        let written = self.values.iter().flatten().filter(|value| !value.parts.is_empty());
        let (count, written) =
            written.fold((0u64, 0u64), |(count, bytes), value| (count + 1, bytes.saturating_add(sum(&value.parts))));
        let others = u64::from(self.shape.len()).saturating_sub(count).saturating_mul(sum(&self.kind.default.parts));
        let kept = bytes_of::<Option<DetachedValue>>(self.values.len());
        [written, others, kept].into_iter().fold(self.shape.bytes(self.kind.size), u64::saturating_add)
    }
}

/// Element number for an index in a view of an array with `size` elements.
#[inline]
pub(super) fn number_within(view: View, size: u32, index: f64) -> Result<u32> {
    within(index, size.saturating_sub(view.start)).map(|at| at + view.start)
}

/// Repeats the numbers. For a single 0, `vec!` allocates memory that is already zero.
fn repeated(numbers: &[f64], count: usize) -> Vec<f64> {
    match numbers {
        [one] => vec![*one; count],
        _ => numbers.repeat(count),
    }
}

/// Nearest whole number to `index`, if it is below `size`. NaN is no valid index.
#[inline]
fn within(index: f64, size: u32) -> Result<u32> {
    match rounded(index) {
        Some(number) if number < size => Ok(number),
        None if index < 0.0 => Err(Fault::INDEX_NEGATIVE),
        _ => Err(Fault::INDEX_TOO_LARGE),
    }
}

/// Nearest whole number to `index`, rounded as by `round` and limited to the largest `u32`; `None` below zero.
#[inline(always)]
fn rounded(index: f64) -> Option<u32> {
    #[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "0 or more, and it saturates")]
    (index >= -0.5).then_some((index + BELOW_HALF) as u32)
}

/// Owner of a container.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Owner {
    /// The controller, for `world` and `flange`. All data may refer to them.
    Controller,
    /// An application or library, for its global data.
    Project {
        /// Number of the project in memory; 0 is the application.
        number: u16,
        /// Whether other projects may refer to the data.
        public: bool,
    },
    /// A program, for its local data. The container is removed at the end of the program.
    Program,
}

impl Owner {
    /// The application.
    pub const APPLICATION: Self = Self::Project { number: 0, public: false };
}
