//! Servers of a controller: one for each generation of the interface, all on one port.

/// Server of a controller.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub enum SoapServer {
    /// Sessions, versions, positions.
    V0,
    /// Applications, data, records.
    V1,
    /// Tasks, debugging, signals.
    V2,
    /// Kinematics, motion, power.
    V3,
}

impl SoapServer {
    /// All servers.
    pub const ALL: [Self; 4] = [Self::V0, Self::V1, Self::V2, Self::V3];

    /// Path in the address of requests.
    #[must_use]
    pub const fn path(self) -> &'static str {
        match self {
            Self::V0 => "/",
            Self::V1 => "/CS8ServerV1",
            Self::V2 => "/CS8ServerV2",
            Self::V3 => "/CS8ServerV3",
        }
    }

    /// Server at a path. An empty path is the path of the first server.
    #[must_use]
    pub fn at_path(path: &str) -> Option<Self> {
        if path.is_empty() { Some(Self::V0) } else { Self::ALL.into_iter().find(|server| server.path() == path) }
    }

    /// Name space of the server's operations. Only the first has no `urn:`.
    #[must_use]
    pub const fn namespace(self) -> &'static str {
        match self {
            Self::V0 => "CS8ServerV0",
            Self::V1 => "urn:CS8ServerV1",
            Self::V2 => "urn:CS8ServerV2",
            Self::V3 => "urn:CS8ServerV3",
        }
    }

    /// Short name, which is also the prefix in documents.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Self::V0 => "V0",
            Self::V1 => "V1",
            Self::V2 => "V2",
            Self::V3 => "V3",
        }
    }
}
