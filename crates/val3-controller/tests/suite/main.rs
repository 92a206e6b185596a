//! Transfers with folders and with an FTP server that misbehaves.

#![allow(
    clippy::unwrap_used,
    clippy::expect_used,
    clippy::panic,
    clippy::indexing_slicing,
    reason = "tests fail loudly"
)]
#![allow(clippy::result_large_err, reason = "there is one result for each push")]
#![allow(clippy::disallowed_methods, reason = "the server of the tests has threads")]

mod bench;
mod connections;
mod crashes;
mod damage;
mod failures;
mod flow;
mod listings;
mod memory;
mod obstacles;
mod pulls;
mod readable;
mod server;
mod tls;
