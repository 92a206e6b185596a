//! `login`: opens a session.

use crate::structure::{operation, structure};

structure! {
    /// Request `login`.
    Login {
        /// Profile name.
        user: Option<String> = "user",
        /// Password of the profile.
        password: Option<String> = "pwd",
    }
}

structure! {
    /// Answer of `login`.
    LoginAnswer {
        /// Number of the session; 0 if the login was rejected.
        session: i32 = "sid",
    }
}

operation!(Login: V0 "login" => LoginAnswer, "loginResponse", without session);
