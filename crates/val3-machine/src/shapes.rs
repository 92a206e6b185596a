//! The looks of an arm for viewers. They have no effect on its motion.

use std::sync::Arc;

/// The shape of a link.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct LinkShape {
    /// The form of its bytes.
    pub format: ShapeFormat,
    /// The contents of its file.
    pub bytes: Arc<[u8]>,
}

/// A form of files that describe shapes.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum ShapeFormat {
    /// glTF in one binary file: metres, y up.
    Glb,
    /// Triangles: millimetres, z up.
    Stl,
}

impl ShapeFormat {
    /// The ending of its files.
    #[must_use]
    pub const fn extension(self) -> &'static str {
        match self {
            Self::Glb => "glb",
            Self::Stl => "stl",
        }
    }

    /// The form of a file with this ending, in any letter case.
    #[must_use]
    pub fn of_extension(extension: &str) -> Option<Self> {
        [Self::Glb, Self::Stl].into_iter().find(|format| format.extension().eq_ignore_ascii_case(extension))
    }
}
