//! Versions and parameters of a controller.

use crate::structure::structure;

structure! {
    /// Version of the interface.
    InterfaceVersion {
        /// Number, for example `1.2`. Servers V2 and V3 exist from 1.2.
        version: Option<String> = "version",
    }
}

structure! {
    /// Part of the software with its version.
    SoftwareVersion {
        /// Name of the part.
        name: Option<String> = "name",
        /// Version.
        version: Option<String> = "version",
    }
}

structure! {
    /// Parameter of a controller.
    ControllerParameter {
        /// Identifier.
        key: Option<String> = "key",
        /// Name for people.
        name: Option<String> = "name",
        /// Value.
        value: Option<String> = "value",
    }
}
