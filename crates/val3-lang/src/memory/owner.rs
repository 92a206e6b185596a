//! The owner of a container.

/// Whose a container is.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Owner {
    /// The controller's: `world` and `flange`, which everything may refer to.
    Controller,
    /// Global data of the application or library that is in memory under this number.
    Project {
        /// The number; 0 is the application.
        number: u16,
        /// Others may use it.
        public: bool,
    },
    /// A program's: it ends with it.
    Program,
}

impl Owner {
    /// The application.
    pub const APPLICATION: Self = Self::Project { number: 0, public: false };
}
