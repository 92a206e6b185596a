//! `stopAndUnloadAll`: stops and unloads all applications. Known from a newer client only; the spelling is inferred.

use crate::structure::{operation, structure};
use crate::value::Empty;

structure! {
    /// Request `stopAndUnloadAll`.
    StopAndUnloadAll {}
}

operation!(StopAndUnloadAll: V2 "stopAndUnloadAll" => Empty, "stopAndUnloadAllResponse");
