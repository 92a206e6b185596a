//! External references of a cell file: arm, application data, meshes.

use camino::Utf8Path;

use crate::mesh::Mesh;

/// Arm properties that a cell depends on.
#[derive(Debug, Clone, Copy)]
pub struct ArmBase {
    /// Number of axes.
    pub axes: usize,
    /// Height of `world` above the mounting face, in mm.
    pub height: f64,
}

/// Access to the data, signals and meshes to which a cell file refers.
pub trait Surroundings {
    /// Reads a mesh file. The error is a message without the path.
    ///
    /// # Errors
    /// The file cannot be read, or is no mesh.
    fn mesh(&mut self, path: &Utf8Path) -> Result<Mesh, String>;

    /// Returns the kind of the data with this name.
    ///
    /// # Errors
    ///
    /// The application has no frame or tool with this name. The error contains a similar name, if one exists.
    fn carrier(&self, name: &str) -> Result<DataKind, Option<String>>;

    /// Returns the signal with this path or name.
    ///
    /// # Errors
    ///
    /// The application has no such signal. The error contains a similar path or name, if one exists.
    fn signal(&self, path: &str) -> Result<KnownSignal, Option<String>>;

    /// Whether the file may belong to another application. Entries with unknown frames, tools or signals are then
    /// omitted.
    fn may_lack_data(&self) -> bool {
        false
    }
}

/// Kinds of data that can be carriers.
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

/// Class and direction of a signal.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct KnownSignal {
    /// Kind of the values.
    pub class: SignalClass,
    /// Whether only programs write the signal.
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
