//! The loadable form of an application or library.

use std::sync::Arc;

use val3_lang::memory::{Kind, PartInit, bytes_of};
use val3_lang::types::{Arm, BaseType, Container, LengthUnit};
use val3_lang::values::Text;
use val3_lang::versions::Version;

use crate::{Operation, Program};

/// Everything of an application or library that the run time needs.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Image {
    /// Its name: that of its folder.
    pub name: String,
    /// The path of its project file.
    pub path: String,
    /// Its files; programs refer to them by number.
    pub files: Vec<String>,
    /// The version it is written for.
    pub version: Version,
    /// The unit of its lengths.
    pub unit: LengthUnit,
    /// The kind of arm that its positions are for, if they are for one.
    pub arm: Option<Arm>,
    /// Bytes of stack of each task.
    pub stack_size: u32,
    /// It uses private items of its libraries as well: it tests them.
    pub sees_private_items: bool,
    /// Global data.
    pub data: Vec<DataDef>,
    /// Links between data, and to inputs and outputs, to be made when the data exist.
    pub links: Vec<LinkInit>,
    /// Programs.
    pub programs: Vec<Program>,
    /// Library identifiers.
    pub libraries: Vec<LibraryDef>,
    /// The items of libraries that it uses or that their interfaces promise.
    pub imports: Vec<Import>,
}

/// Global data.
#[derive(Debug, Clone, PartialEq)]
pub struct DataDef {
    /// The name.
    pub name: String,
    /// Whether other applications may use it.
    pub public: bool,
    /// Type, container and values at the start.
    pub init: PartInit,
}

/// A link of one value at the start.
#[derive(Debug, Clone, PartialEq)]
pub struct LinkInit {
    /// The data, by number.
    pub data: u32,
    /// The way from a value of the data through fields of user types: number of the value, then of the field.
    pub path: Vec<(u32, u32)>,
    /// The number of the value in the innermost container.
    pub value: u32,
    /// The number of the link among those of the value.
    pub link: u32,
    /// The target of the link.
    pub target: LinkTarget,
}

/// The target of a link.
#[derive(Debug, Clone, PartialEq)]
pub enum LinkTarget {
    /// An input, output or line, by type and path as the file writes it (`BasicIO-1\%I0`).
    Port(BaseType, String),
    /// A frame or tool.
    Father(FatherLink),
    /// The input or output that a `dio` is linked to; without a link, the one of the same name (the gripper of s5 and
    /// s6).
    Signal(FatherLink),
}

/// Data that a value refers to, as a file names it: `fTray[0]`, `tSlot["a"].fIn[0]`, `lib:fTray`.
#[derive(Debug, Clone, PartialEq, Eq, Hash)]
pub struct FatherLink {
    /// The library identifier, if it is data of a library.
    pub library: Option<String>,
    /// The name of the data; `world` and `flange` too.
    pub name: String,
    /// Which of its values: an index (`2`, `1,3`), or a key.
    pub at: String,
    /// Names of fields of user types, each with the index of its value.
    pub fields: Vec<(String, String)>,
}

/// A library identifier.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct LibraryDef {
    /// The identifier.
    pub alias: String,
    /// The path of the interface as the project writes it.
    pub path: String,
    /// Whether it is loaded with the application.
    pub autoload: bool,
}

/// An item that an application expects of a library.
#[derive(Debug, Clone, PartialEq)]
pub struct Import {
    /// The library identifier, by number.
    pub library: u16,
    /// The name of the data or program.
    pub name: String,
    /// The required kind of item.
    pub kind: ImportKind,
}

/// The required kind of an imported item.
#[derive(Debug, Clone, PartialEq)]
pub enum ImportKind {
    /// Data of this type.
    Data(Arc<Kind>, Container),
    /// A program with these parameters: type, container, by reference.
    Program(Vec<(Arc<Kind>, Container, bool)>),
    /// The interface lacks the item, so no library has it.
    Missing,
}

impl Image {
    /// The number of a program.
    #[must_use]
    pub fn program(&self, name: &str) -> Option<u16> {
        self.programs.iter().position(|program| program.name == name).and_then(|at| u16::try_from(at).ok())
    }

    /// Bytes of its programs in memory, as far as they depend on the size of the code.
    #[must_use]
    pub fn code_bytes(&self) -> u64 {
        let bytes =
            |program: &Program| bytes_of::<Operation>(program.code.len()) + bytes_of::<Text>(program.texts.len());
        self.programs.iter().map(bytes).sum()
    }

    /// The number of global data.
    #[must_use]
    pub fn data(&self, name: &str) -> Option<u16> {
        self.data.iter().position(|data| data.name == name).and_then(|at| u16::try_from(at).ok())
    }
}
