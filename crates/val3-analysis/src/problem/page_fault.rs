//! The faults of user pages.

use smol_str::SmolStr;

/// A fault in the bindings of a user page, or a page that does not exist.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum PageFault {
    /// The file is no JSON.
    NoJson {
        /// What is expected at the place.
        expected: &'static str,
    },
    /// Data that the application does not have.
    UnknownData {
        /// The name.
        name: SmolStr,
        /// The most similar name.
        near: Option<SmolStr>,
    },
    /// A field that a user type does not have.
    UnknownField {
        /// The name.
        name: SmolStr,
        /// The user type.
        of_type: SmolStr,
        /// The most similar name.
        near: Option<SmolStr>,
    },
    /// An attribute, which has one value, is bound to a position or an object.
    SeveralValues {
        /// The path of the data.
        path: SmolStr,
        /// The type of the data.
        found: SmolStr,
        /// The attribute: `innerHTML`.
        attribute: SmolStr,
    },
    /// An index outside of the data.
    Index {
        /// The name of the data.
        name: SmolStr,
        /// The index as written.
        index: SmolStr,
        /// The declared sizes: `3,4`.
        size: SmolStr,
    },
    /// A program that the application does not have.
    UnknownProgram {
        /// The name.
        name: SmolStr,
        /// The most similar name.
        near: Option<SmolStr>,
    },
    /// An event of the page calls a program with parameters.
    Parameters {
        /// The program.
        name: SmolStr,
    },
    /// An id that no element of the page has.
    UnknownElement {
        /// The id.
        id: SmolStr,
        /// The most similar id.
        near: Option<SmolStr>,
    },
    /// Two elements of the page have one id.
    ElementTwice {
        /// The id.
        id: SmolStr,
    },
    /// A program shows a page that the application does not have.
    UnknownPage {
        /// The name.
        name: SmolStr,
        /// The most similar name.
        near: Option<SmolStr>,
    },
}
