//! References of a cell's file: the arm, the data of an application, meshes.

use camino::Utf8Path;

use crate::mesh::Mesh;

/// The arm's properties for building a cell.
#[derive(Debug, Clone, Copy)]
pub struct ArmBase {
    /// Number of axes.
    pub axes: usize,
    /// Height of `world` above the mounting face, in mm.
    pub height: f64,
}

/// Access to the data and meshes to which a cell's file refers.
pub trait Surroundings {
    /// Reads a mesh file. The error is a message without the path.
    ///
    /// # Errors
    /// The file cannot be read, or is no mesh.
    fn mesh(&mut self, path: &Utf8Path) -> Result<Mesh, String>;

    /// Returns the kind of a datum.
    ///
    /// # Errors
    /// Without a frame or tool of this name; a similar name, if one exists.
    fn carrier(&self, name: &str) -> Result<DataKind, Option<String>>;

    /// Returns a signal, by path or name.
    ///
    /// # Errors
    /// Without a signal of this name; a similar path or name, if one exists.
    fn signal(&self, path: &str) -> Result<KnownSignal, Option<String>>;

    /// Whether the file may be about another application, so that things in unknown frames and tools are left out.
    fn may_lack_data(&self) -> bool {
        false
    }
}

/// Kinds of data that can carry things.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum DataKind {
    /// A frame.
    Frame,
    /// A tool.
    Tool,
}

impl DataKind {
    pub(crate) const fn words(self) -> &'static str {
        match self {
            Self::Frame => "a frame",
            Self::Tool => "a tool",
        }
    }
}

/// An input or output.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct KnownSignal {
    /// Kind of the values.
    pub class: SignalClass,
    /// Whether only programs write it.
    pub is_output: bool,
}

/// Kinds of signals.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum SignalClass {
    /// True or false.
    Digital,
    /// A number.
    Analog,
    /// A library may add the signal while the application runs.
    Unknown,
}
