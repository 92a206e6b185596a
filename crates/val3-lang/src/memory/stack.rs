//! The stack of a task: the frames of the programs it is in, one behind the other.

use super::{Link, Place, StoreId, View};
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
