//! Faults of user pages.

use smol_str::SmolStr;

/// A fault in the bindings of a user page, or a page that does not exist.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum PageFault {
    /// The file is not valid JSON.
    NoJson {
        /// Expected token.
        expected: &'static str,
    },
    /// Data that do not exist in the application.
    UnknownData {
        /// The name.
        name: SmolStr,
        /// The most similar name.
        near: Option<SmolStr>,
    },
    /// A field that does not exist in the user type.
    UnknownField {
        /// The name.
        name: SmolStr,
        /// The user type.
        of_type: SmolStr,
        /// The most similar name.
        near: Option<SmolStr>,
    },
    /// A position or object is bound to an attribute, which has only one value.
    SeveralValues {
        /// Data path.
        path: SmolStr,
        /// Type of the data.
        found: SmolStr,
        /// Attribute name, for example `innerHTML`.
        attribute: SmolStr,
    },
    /// An index outside of the declared size.
    Index {
        /// Name of the data.
        name: SmolStr,
        /// The index as written.
        index: SmolStr,
        /// Declared sizes, for example `3,4`.
        size: SmolStr,
    },
    /// A program that does not exist in the application.
    UnknownProgram {
        /// The name.
        name: SmolStr,
        /// The most similar name.
        near: Option<SmolStr>,
    },
    /// A page event calls a program with parameters.
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
    /// Two elements of the page have the same id.
    ElementTwice {
        /// The id.
        id: SmolStr,
    },
    /// A program shows a page that does not exist in the application.
    UnknownPage {
        /// The name.
        name: SmolStr,
        /// The most similar name.
        near: Option<SmolStr>,
    },
}
