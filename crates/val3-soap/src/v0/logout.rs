//! `logout`: closes the session.

use crate::structure::{operation, structure};
use crate::value::Empty;

structure! {
    /// Request `logout`.
    Logout {}
}

operation!(Logout: V0 "logout" => Empty, "logoutResponse");
