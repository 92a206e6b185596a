//! Fixtures for tests: complete VAL 3 projects from a few lines of text.
//!
//! # Listings
//! A *listing* is the short notation in which examples and tests show a program with its data. It is converted to the
//! `.pjx`, `.dtx` and `.pgx` files of one or more applications.
//!
//! ```text
//! num nCount                          private data of the application, one declaration a line
//! public point pPick[3]               an array; num nGrid[3,4] has two dimensions
//! dio dIn[""]                         a collection; dio dIn["door","lamp"] has two keys
//! string sName = "box"                an initial value of the first element (data of type bool, num or string)
//! library part "Disk://part/part.pjx"             a library identifier
//! library tray "./tray/tray.pjx" autoload=false
//! type Slot "Disk://Slot/Slot.pjx"    a user type
//! version s7.11.3                     the project's version (default s7.11)
//!
//! public program pick(num x_n, string& x_s, num& x_a[], num& x_g[,], num& x_c[""])
//!   num l_i                           locals are declared between the head and `begin`
//! begin
//!   x_s="a"
//! end
//!
//! --- part                            the following lines belong to the project Disk://part/part.pjx
//! public num nWeight
//!
//! === main/main.dtx                   the following lines are the file itself, up to the next === or ---
//! <?xml ...
//! ```
//! Lines outside of `program … end` that are no declarations are the body of the program `start` of the project, so an
//! example can be one line. The first project is called `main`. Comments and blank lines between declarations are
//! skipped.
//!
//! - A user type without a `type` line is recognised only after `public` or `private`.
//! - `=== /configs/arm.cfx` names a file in the controller's `usr` folder instead of `usrapp`.
//! - A raw file replaces the generated file; a raw `.pgx` in a project's folder is added to its programs.
//! - Points and frames have the father `world`, tools `flange`.
//! - The common indentation of all lines is not part of the listing.

#![allow(
    clippy::panic,
    clippy::expect_used,
    clippy::unwrap_used,
    clippy::indexing_slicing,
    reason = "a bad listing is a fault of the test that holds it, and the panic says so"
)]

mod declaration;
mod fixture;
mod indent;
mod listing;
mod markers;
mod write;

pub use fixture::{EMPTY_STOP, Fixture, ROOT};
pub use markers::{MarkedText, Note, extract_markers};
