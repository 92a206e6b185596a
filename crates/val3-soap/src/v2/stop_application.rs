//! `stopApplication`: stops the application. Known from a newer client only; the spelling is inferred.

use crate::structure::{operation, structure};
use crate::value::Empty;

structure! {
    /// Request `stopApplication`.
    StopApplication {}
}

operation!(StopApplication: V2 "stopApplication" => Empty, "stopApplicationResponse");
