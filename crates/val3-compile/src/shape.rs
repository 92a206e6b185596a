//! Shapes of declared containers.

use std::collections::BTreeMap;

use val3_lang::memory::ContainerShape;
use val3_lang::types::Container;

/// Returns the shape of a container with these sizes, or of a collection without keys.
pub(crate) fn shape(container: Container, sizes: &[u32]) -> ContainerShape {
    if container == Container::Collection {
        return ContainerShape::Collection(BTreeMap::new());
    }
    let mut all = [1; 3];
    all.iter_mut().zip(sizes).for_each(|(to, size)| *to = *size);
    ContainerShape::Array { dims: u8::try_from(sizes.len()).unwrap_or(1).max(1), sizes: all }
}
