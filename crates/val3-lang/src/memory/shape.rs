//! Layout of a container: one value, an array or a collection.

use std::collections::BTreeMap;

use super::bytes_of;
use crate::values::Text;

/// Access to the elements of a container.
#[derive(Debug, Clone, PartialEq)]
pub enum ContainerShape {
    /// By 1 to 3 indexes; missing dimensions have size 1.
    Array {
        /// Number of dimensions.
        dims: u8,
        /// Sizes.
        sizes: [u32; 3],
    },
    /// By keys, in alphabetical order. Each key has its element's number in the container.
    Collection(BTreeMap<Text, u32>),
}

impl ContainerShape {
    /// A single value.
    pub const ELEMENT: Self = Self::Array { dims: 1, sizes: [1, 1, 1] };

    /// Creates a one-dimensional array of this size.
    #[must_use]
    pub const fn array(size: u32) -> Self {
        Self::Array { dims: 1, sizes: [size, 1, 1] }
    }

    /// Number of elements. A declared size may exceed the memory.
    #[must_use]
    #[inline]
    pub fn len(&self) -> u32 {
        match self {
            Self::Array { sizes, .. } => sizes.iter().fold(1, |product: u32, size| product.saturating_mul(*size)),
            Self::Collection(keys) => u32::try_from(keys.len()).unwrap_or(u32::MAX),
        }
    }

    /// Numbers of all elements, in the order of the indexes or keys.
    #[must_use]
    pub fn numbers(&self) -> Vec<u32> {
        match self {
            Self::Array { .. } => (0..self.len()).collect(),
            Self::Collection(keys) => keys.values().copied().collect(),
        }
    }

    /// Whether there are no elements.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.len() == 0
    }

    /// Size of the keys in bytes.
    pub(super) fn key_bytes(&self) -> u64 {
        match self {
            Self::Array { .. } => 0,
            Self::Collection(keys) => KEY_BYTES.saturating_mul(keys.len() as u64),
        }
    }

    /// Number of the element with this subscript in a data file: `3`, `1,2`, `home`.
    #[must_use]
    pub fn number_of_text(&self, at: &str) -> Option<u32> {
        let sizes = match self {
            Self::Collection(keys) => return keys.get(&Text::from(at)).copied(),
            Self::Array { sizes, .. } => sizes,
        };
        let mut indexes = [0; 3];
        for (index, text) in indexes.iter_mut().zip(at.split(',')) {
            *index = text.trim().parse().ok()?;
        }
        let [x, y, z] = indexes;
        let [_, rows, columns] = sizes;
        indexes.iter().zip(sizes).all(|(index, size)| index < size).then(|| (x * rows + y) * columns + z)
    }
}

/// Size of a key with its element number, in bytes.
pub(super) const KEY_BYTES: u64 = bytes_of::<(Text, u32)>(1);
