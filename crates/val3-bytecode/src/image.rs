//! Loadable form of applications and libraries.

use std::sync::Arc;

use val3_lang::memory::{PartInit, ValueType, bytes_of};
use val3_lang::types::{Arm, BaseType, Container, LengthUnit};
use val3_lang::values::Text;
use val3_lang::versions::Version;

use crate::{Opcode, Program};

/// An application or library as the virtual machine executes it.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Image {
    /// Name: the name of the folder.
    pub name: String,
    /// Path of the project file.
    pub path: String,
    /// Files; programs refer to them by number.
    pub files: Vec<String>,
    /// VAL 3 version for which it is written.
    pub version: Version,
    /// Unit of lengths.
    pub unit: LengthUnit,
    /// Kind of arm that positions are for; `None` if they fit both kinds.
    pub arm: Option<Arm>,
    /// Stack size per task, in bytes.
    pub stack_size: u32,
    /// Whether private items in libraries can be used too, as tests do.
    pub sees_private_items: bool,
    /// Global data.
    pub data: Vec<DataDef>,
    /// Links between data, and to inputs and outputs, which are set after the data are created.
    pub links: Vec<LinkInit>,
    /// Programs.
    pub programs: Vec<Program>,
    /// Library identifiers.
    pub libraries: Vec<LibraryDef>,
    /// Library items that programs use or that the interfaces declare.
    pub imports: Vec<Import>,
}

/// Definition of global data.
#[derive(Debug, Clone, PartialEq)]
pub struct DataDef {
    /// Name.
    pub name: String,
    /// Whether other applications may use it.
    pub public: bool,
    /// Type, container and initial values.
    pub init: PartInit,
}

/// Initial link in one value.
#[derive(Debug, Clone, PartialEq)]
pub struct LinkInit {
    /// Number of the data.
    pub data: u32,
    /// Path from an element of the data through fields of user types: number of the element, then of the field.
    pub path: Vec<(u32, u32)>,
    /// Number of the value in the innermost container.
    pub value: u32,
    /// Number of the link within the value.
    pub link: u32,
    /// Target of the link.
    pub target: LinkTarget,
}

/// Target of a link.
#[derive(Debug, Clone, PartialEq)]
pub enum LinkTarget {
    /// An input, output or channel, by type and by path as in the data file (`BasicIO-1\%I0`).
    Port(BaseType, String),
    /// A frame or tool.
    Father(FatherLink),
    /// The input or output that a `dio` is linked to; if it has no link, the signal with the `dio`'s name (the gripper
    /// of s5 and s6).
    Signal(FatherLink),
}

/// Reference to data, as in a data file: `fTray[0]`, `tSlot["a"].fIn[0]`, `lib:fTray`.
#[derive(Debug, Clone, PartialEq, Eq, Hash)]
pub struct FatherLink {
    /// Library identifier for data of a library.
    pub library: Option<String>,
    /// Name of the data, or `world` or `flange`.
    pub name: String,
    /// Index (`2`, `1,3`) or key of the element.
    pub at: String,
    /// Fields of user types, each with its element's index.
    pub fields: Vec<(String, String)>,
}

/// Declaration of a library identifier.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct LibraryDef {
    /// Identifier.
    pub alias: String,
    /// Path of the interface, as in the project file.
    pub path: String,
    /// Whether the library is loaded with the application.
    pub autoload: bool,
}

/// Item that an application expects from a library.
#[derive(Debug, Clone, PartialEq)]
pub struct Import {
    /// Number of the library identifier.
    pub library: u16,
    /// Name of the data or program.
    pub name: String,
    /// Expected kind of item.
    pub kind: ImportKind,
}

/// Expected kind of imported item.
#[derive(Debug, Clone, PartialEq)]
pub enum ImportKind {
    /// Data with this type.
    Data(Arc<ValueType>, Container),
    /// A program with these parameters: type, container, whether by reference.
    Program(Vec<(Arc<ValueType>, Container, bool)>),
    /// The interface does not declare the item, so no library has it.
    Missing,
}

impl Image {
    /// Returns the number of a program.
    #[must_use]
    pub fn program(&self, name: &str) -> Option<u16> {
        self.programs.iter().position(|program| program.name == name).and_then(|at| u16::try_from(at).ok())
    }

    /// Returns the size of the programs in memory, in bytes: only the parts that depend on the size of the code.
    #[must_use]
    pub fn code_bytes(&self) -> u64 {
        let bytes = |program: &Program| bytes_of::<Opcode>(program.code.len()) + bytes_of::<Text>(program.texts.len());
        self.programs.iter().map(bytes).sum()
    }

    /// Returns the number of global data.
    #[must_use]
    pub fn data(&self, name: &str) -> Option<u16> {
        self.data.iter().position(|data| data.name == name).and_then(|at| u16::try_from(at).ok())
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::assemble;

    #[test]
    fn programs_and_data_are_found_by_name() {
        let text = "data nA num[1]\ndata nB num[1]\nprogram a\nReturn\nend\nprogram b\nReturn\nend";
        let image = assemble(text).unwrap();
        assert_eq!((image.program("a"), image.program("b"), image.program("nA")), (Some(0), Some(1), None));
        assert_eq!((image.data("nA"), image.data("nB"), image.data("a")), (Some(0), Some(1), None));
    }

    #[test]
    fn the_size_of_the_code_grows_with_operations_and_texts() {
        let size = |code: &str| assemble(&format!("program a\nframe t1\n{code}\nend")).unwrap().code_bytes();
        let (empty, operation) = (size("Return"), bytes_of::<Opcode>(1));
        assert_eq!(empty, operation);
        assert_eq!(size("Line Line Return"), 3 * operation);
        assert_eq!(size("TextMove t0 \"a\" TextMove t0 \"b\" Return"), 3 * operation + bytes_of::<Text>(2));
        let both = assemble("program a\nReturn\nend\nprogram b\nReturn\nend").unwrap().code_bytes();
        assert_eq!(both, 2 * empty);
    }
}
