//! Faults of the file.

use std::fmt;

/// Fault of the file, at an offset.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct FileFault {
    /// Byte offset in the text.
    pub offset: usize,
    /// Kind of the fault, whose display is the message.
    pub kind: FaultKind,
}

/// Kind of a fault.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum FaultKind {
    /// The text is no well-formed XML.
    Xml,
    /// The root element is not `TOPICSLIST`.
    Root,
    /// An element has no such attribute, or an empty one.
    Missing {
        /// Name of the element.
        element: &'static str,
        /// Name of the attribute.
        attribute: &'static str,
    },
    /// `Card`, `Channel` or `Equipment` is not 0. One of them is the number in the device name, but it is unknown which
    /// one.
    OtherDevice {
        /// Name of the attribute.
        attribute: &'static str,
    },
    /// The `IDModule` of a module is neither `BOOLEAN` nor `WORD`.
    Module(String),
    /// An item's `Syntaxe` is unknown in its table, or has addresses beyond the table.
    Syntax(String),
    /// An item's `Offset` is not the address in its `Syntaxe`.
    Offset {
        /// Name of the item.
        item: String,
        /// `Offset` as written.
        offset: String,
        /// Address in the `Syntaxe`.
        address: u16,
    },
    /// Two items of a topic have the same name in the same table.
    RepeatedName(String),
    /// Two items have the same address.
    Overlap {
        /// The later item.
        item: String,
        /// The earlier item.
        other: String,
        /// First address of both.
        address: u16,
    },
    /// No item has these addresses, and later items exist.
    Gap {
        /// First address.
        first: u32,
        /// Last address.
        last: u32,
    },
    /// A module's `OutputSize` is not the total size of the items.
    Size {
        /// `OutputSize` as written.
        stated: String,
        /// Size of the items in bits.
        bits: u32,
    },
    /// The `ConnectionNumber` or `TCP_Port` of a topic is no number in its range.
    Parameter {
        /// Name of the attribute.
        attribute: &'static str,
        /// Value as written.
        value: String,
    },
}

impl FaultKind {
    /// Whether names or types of items are unknown.
    #[must_use]
    pub const fn hides_items(&self) -> bool {
        use FaultKind::{Missing, Module, OtherDevice, Root, Syntax, Xml};
        matches!(self, Xml | Root | Missing { .. } | OtherDevice { .. } | Module(_) | Syntax(_))
    }

    /// Whether the addresses are certain nevertheless, so that a server can use the file.
    #[must_use]
    pub const fn is_harmless(&self) -> bool {
        matches!(self, Self::Gap { .. } | Self::Size { .. })
    }
}

impl fmt::Display for FaultKind {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Xml => write!(f, "the XML is not well-formed here"),
            Self::Root => write!(f, "the file has no root element `TOPICSLIST`"),
            Self::Missing { element, attribute } => write!(f, "`{element}` has no `{attribute}`"),
            Self::OtherDevice { attribute } => {
                write!(f, "`{attribute}` is not 0, and it is unknown which links belong to such a topic")
            }
            Self::Module(id) => write!(f, "`IDModule` is `BOOLEAN` or `WORD`, not `{id}`"),
            Self::Syntax(text) => write!(
                f,
                "`Syntaxe` is `%Q` or `%I`, in words `%QW` or `%IW`, with an address up to 65535, such as `%Q1:8`, not \
                 `{text}`"
            ),
            Self::Offset { item, offset, address } => {
                write!(f, "`Offset` of `{item}` is {offset}, but its `Syntaxe` has the address {address}")
            }
            Self::RepeatedName(name) => write!(f, "another item of this table is called `{name}`"),
            Self::Overlap { item, other, address } => {
                write!(f, "`{item}` and `{other}` have the same address {address}")
            }
            Self::Gap { first, last } if first == last => write!(f, "no item has the address {first}"),
            Self::Gap { first, last } => write!(f, "no item has the addresses {first} to {last}"),
            Self::Size { stated, bits } => {
                write!(f, "`OutputSize` is {stated}, but the items of the module have {bits} bits")
            }
            Self::Parameter { attribute, value } => {
                write!(f, "`{attribute}` is a number from 1 to 65535, not `{value}`")
            }
        }
    }
}
