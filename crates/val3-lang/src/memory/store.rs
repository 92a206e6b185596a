//! One container with its values.

use std::sync::Arc;

use super::{Element, Kind, Lanes, Link, Owner, PartInit, Place, Shape, StoreId, View, bytes_of};
use crate::fault::{Fault, Result};
use crate::values::Text;
use crate::values::numbers::BELOW_HALF;

/// Bytes of a container without its values and keys.
const STORE_BYTES: u64 = bytes_of::<Store>(1);

/// A container: its shape and its values in lanes.
///
/// The value of number `n` has its lanes at `n * kind.size`. A value that leaves a collection leaves a gap, which the
/// next one fills: the others keep their places, and with them what refers to them.
#[derive(Debug, Clone)]
pub struct Store {
    pub(super) generation: u32,
    /// The type of its values.
    pub kind: Arc<Kind>,
    /// How they are reached.
    pub shape: Shape,
    /// Whose it is: what may refer to it. A local one cannot grow or shrink (2.5.4).
    pub owner: Owner,
    /// It is a field of a value of a user type: it can grow and shrink even if it is local (7.3).
    pub(super) field: bool,
    pub(super) gaps: Vec<u32>,
    /// Numbers.
    pub nums: Vec<f64>,
    /// Texts.
    pub texts: Vec<Text>,
    /// Links.
    pub links: Vec<Link>,
    /// Containers within the values.
    pub parts: Vec<StoreId>,
}

impl Store {
    /// A container of values of a built-in type, each with the default. For user types:
    /// [`Memory::create`](super::Memory::create).
    pub(super) fn filled(kind: Arc<Kind>, shape: Shape) -> Self {
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
        }
    }

    /// The bytes it takes, without those of the containers in its values. A gap counts as a value.
    pub(super) fn bytes(&self) -> u64 {
        let Self { nums, texts, links, parts, .. } = self;
        let lanes = bytes_of::<f64>(nums.len())
            + bytes_of::<Text>(texts.len())
            + bytes_of::<Link>(links.len())
            + bytes_of::<StoreId>(parts.len());
        STORE_BYTES + self.shape.key_bytes() + lanes
    }

    /// Exchanges the values; type and owner stay.
    pub(super) fn exchange(&mut self, other: &mut Self) {
        std::mem::swap(&mut self.shape, &mut other.shape);
        std::mem::swap(&mut self.gaps, &mut other.gaps);
        std::mem::swap(&mut self.nums, &mut other.nums);
        std::mem::swap(&mut self.texts, &mut other.texts);
        std::mem::swap(&mut self.links, &mut other.links);
        std::mem::swap(&mut self.parts, &mut other.parts);
    }

    /// Takes the values of another array of the same type and sizes, in place. `false` for any other container.
    pub(super) fn overwrite(&mut self, from: &Self) -> bool {
        let alike = match (&self.shape, &from.shape) {
            (Shape::Array { sizes, .. }, Shape::Array { sizes: others, .. }) => sizes == others,
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

    /// Removes the container: no reference has its new generation. Returns the containers in its values.
    pub(super) fn empty(&mut self) -> Vec<StoreId> {
        self.generation += 1;
        self.shape = Shape::array(0);
        self.owner = Owner::Controller;
        self.gaps = Vec::new();
        (self.nums, self.texts, self.links) = (Vec::new(), Vec::new(), Vec::new());
        std::mem::take(&mut self.parts)
    }

    /// The place of a value by its number among all values.
    #[must_use]
    #[inline]
    pub fn place(&self, id: StoreId, number: u32) -> Place {
        Place::new(id, self.kind.size * number)
    }

    /// The number of a value of a one-dimensional array from an index, which is rounded (2.5.3).
    ///
    /// # Errors
    /// 21 below zero, 20 beyond the size.
    #[inline]
    pub fn number1(&self, view: View, index: f64) -> Result<u32> {
        match self.shape {
            Shape::Array { dims: 1, sizes: [size, ..] } => {
                within(index, size.saturating_sub(view.start)).map(|at| at + view.start)
            }
            _ => Err(Fault::INDEX_TOO_LARGE),
        }
    }

    /// The number of a value of an array of two dimensions.
    ///
    /// # Errors
    /// 21 below zero, 20 beyond the size.
    #[inline]
    pub fn number2(&self, [i, j]: [f64; 2]) -> Result<u32> {
        match self.shape {
            Shape::Array { dims: 2, sizes: [rows, columns, _] } => Ok(within(i, rows)? * columns + within(j, columns)?),
            _ => Err(Fault::INDEX_TOO_LARGE),
        }
    }

    /// Where a number of a one-dimensional array of numbers is: the lane is one of `nums` only if the index is one of
    /// the array, for each value has one lane.
    #[inline(always)]
    pub(super) fn lane1(&self, view: View, index: f64) -> Option<usize> {
        match self.shape {
            Shape::Array { dims: 1, .. } => Some(view.start as usize + rounded(index)? as usize),
            _ => None,
        }
    }

    /// As [`lane1`](Self::lane1), of an array of two dimensions.
    #[inline(always)]
    pub(super) fn lane2(&self, [i, j]: [f64; 2]) -> Option<usize> {
        match self.shape {
            Shape::Array { dims: 2, sizes: [_, columns, _] } => {
                let (i, j) = (rounded(i)?, rounded(j)?);
                (j < columns).then_some(i as usize * columns as usize + j as usize)
            }
            _ => None,
        }
    }

    /// The number of a value of an array of three dimensions.
    ///
    /// # Errors
    /// 21 below zero, 20 beyond the size.
    pub fn number3(&self, [i, j, k]: [f64; 3]) -> Result<u32> {
        match self.shape {
            Shape::Array { dims: 3, sizes: [x, y, z] } => Ok((within(i, x)? * y + within(j, y)?) * z + within(k, z)?),
            _ => Err(Fault::INDEX_TOO_LARGE),
        }
    }

    /// The number of the value under a key.
    ///
    /// # Errors
    /// 20 if there is no such key.
    pub fn number_of(&self, key: &Text) -> Result<u32> {
        match &self.shape {
            Shape::Collection(keys) => keys.get(key).copied().ok_or(Fault::INDEX_TOO_LARGE),
            Shape::Array { .. } => Err(Fault::INDEX_TOO_LARGE),
        }
    }

    /// The number of the value that a file names: `3`, `1,2`, `home`.
    #[must_use]
    pub fn number_of_text(&self, at: &str) -> Option<u32> {
        self.shape.number_of_text(at)
    }

    /// Appends the default lanes of one value of a built-in type; of a user type all but its parts.
    pub(super) fn push_default(&mut self) {
        let Element { nums, texts, links, .. } = &self.kind.default;
        self.nums.extend_from_slice(nums);
        self.texts.extend_from_slice(texts);
        self.links.extend_from_slice(links);
    }
}

impl Shape {
    /// Bytes that a container of this shape takes with values of this size, without those that the values hold.
    #[must_use]
    pub fn bytes(&self, size: Lanes) -> u64 {
        STORE_BYTES.saturating_add(self.key_bytes()).saturating_add(size.bytes().saturating_mul(self.len().into()))
    }
}

impl PartInit {
    /// Bytes of the container and those within its values, with what is kept of its values at the start.
    #[must_use]
    pub fn bytes(&self) -> u64 {
        let sum = |parts: &[Self]| parts.iter().map(Self::bytes).fold(0, u64::saturating_add);
        let written = self.values.iter().flatten().filter(|value| !value.parts.is_empty());
        let (count, written) =
            written.fold((0u64, 0u64), |(count, bytes), value| (count + 1, bytes.saturating_add(sum(&value.parts))));
        let others = u64::from(self.shape.len()).saturating_sub(count).saturating_mul(sum(&self.kind.default.parts));
        let kept = bytes_of::<Option<Element>>(self.values.len());
        [written, others, kept].into_iter().fold(self.shape.bytes(self.kind.size), u64::saturating_add)
    }
}

/// The number of a value by its index in a view of an array with `size` values.
#[inline]
pub(super) fn number_within(view: View, size: u32, index: f64) -> Result<u32> {
    within(index, size.saturating_sub(view.start)).map(|at| at + view.start)
}

/// Copies of some numbers, one after the other. For a single number that is 0, `vec!` takes memory that is zero already.
fn repeated(numbers: &[f64], count: usize) -> Vec<f64> {
    match numbers {
        [one] => vec![*one; count],
        _ => numbers.repeat(count),
    }
}

/// The whole number nearest to `index` if it is one of `size` indexes. A number that is none is no index either.
#[inline]
fn within(index: f64, size: u32) -> Result<u32> {
    match rounded(index) {
        Some(number) if number < size => Ok(number),
        None if index < 0.0 => Err(Fault::INDEX_NEGATIVE),
        _ => Err(Fault::INDEX_TOO_LARGE),
    }
}

/// The whole number nearest to `index`, or the greatest there is; `None` below zero. It is rounded as by `round`.
#[inline(always)]
fn rounded(index: f64) -> Option<u32> {
    #[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "0 or more, and it saturates")]
    (index >= -0.5).then_some((index + BELOW_HALF) as u32)
}
