//! The owner of a container.

/// Owner of a container.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Owner {
    /// The controller, for `world` and `flange`. All data may refer to them.
    Controller,
    /// An application or library, for its global data.
    Project {
        /// Number of the project in memory; 0 is the application.
        number: u16,
        /// Whether other projects may refer to the data.
        public: bool,
    },
    /// A program, for its local data. The container is removed at the end of the program.
    Program,
}

impl Owner {
    /// The application.
    pub const APPLICATION: Self = Self::Project { number: 0, public: false };
}
