//! The shape of a container: one value, an array or a collection.

use std::collections::BTreeMap;

use super::bytes_of;
use crate::values::Text;

/// How the values of a container are reached.
#[derive(Debug, Clone, PartialEq)]
pub enum Shape {
    /// Under 1 to 3 indexes; the dimensions that are missing have size 1.
    Array {
        /// Number of dimensions.
        dims: u8,
        /// Their sizes.
        sizes: [u32; 3],
    },
    /// Under keys, in alphabetical order; each has the place of its value among all values.
    Collection(BTreeMap<Text, u32>),
}

impl Shape {
    /// One value.
    pub const ELEMENT: Self = Self::Array { dims: 1, sizes: [1, 1, 1] };

    /// An array of this size.
    #[must_use]
    pub const fn array(size: u32) -> Self {
        Self::Array { dims: 1, sizes: [size, 1, 1] }
    }

    /// The number of values. One that a file declares may be beyond all memory.
    #[must_use]
    #[inline]
    pub fn len(&self) -> u32 {
        match self {
            Self::Array { sizes, .. } => sizes.iter().fold(1, |product: u32, size| product.saturating_mul(*size)),
            Self::Collection(keys) => u32::try_from(keys.len()).unwrap_or(u32::MAX),
        }
    }

    /// There is no value.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.len() == 0
    }

    /// Bytes of the keys.
    pub(super) fn key_bytes(&self) -> u64 {
        match self {
            Self::Array { .. } => 0,
            Self::Collection(keys) => KEY_BYTES.saturating_mul(keys.len() as u64),
        }
    }

    /// The number of the value that a file names: `3`, `1,2`, `home`.
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

/// Bytes of a key of a collection with the place of its value.
pub(super) const KEY_BYTES: u64 = bytes_of::<(Text, u32)>(1);
