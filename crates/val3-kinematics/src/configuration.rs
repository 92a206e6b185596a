//! Configurations (manual 9.7).

/// Side of the arm on which the flange is.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Shoulder {
    /// `lefty`
    Lefty,
    /// `righty`
    Righty,
}

/// Sign of axis 3 of a six-axis arm.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Elbow {
    /// `epositive`: axis 3 is at 0 or above.
    Positive,
    /// `enegative`
    Negative,
}

/// Sign of axis 5 of a six-axis arm.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Wrist {
    /// `wpositive`: axis 5 is at 0 or above.
    Positive,
    /// `wnegative`
    Negative,
}

/// Configuration of a joint position. It identifies a branch of the inverse kinematics.
///
/// Elbow and wrist of a SCARA arm are always positive.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct Configuration {
    /// Shoulder.
    pub shoulder: Shoulder,
    /// Elbow.
    pub elbow: Elbow,
    /// Wrist.
    pub wrist: Wrist,
}

impl Configuration {
    /// Branches of a six-axis arm. Among equally good branches, the first one is preferred.
    pub const SIX_AXIS: [Self; 8] = {
        use {Elbow as E, Shoulder::*, Wrist as W};
        [
            Self::new(Lefty, E::Positive, W::Positive),
            Self::new(Lefty, E::Positive, W::Negative),
            Self::new(Lefty, E::Negative, W::Positive),
            Self::new(Lefty, E::Negative, W::Negative),
            Self::new(Righty, E::Positive, W::Positive),
            Self::new(Righty, E::Positive, W::Negative),
            Self::new(Righty, E::Negative, W::Positive),
            Self::new(Righty, E::Negative, W::Negative),
        ]
    };

    /// Branches of a SCARA arm.
    pub const SCARA: [Self; 2] = [Self::scara(Shoulder::Lefty), Self::scara(Shoulder::Righty)];

    /// Creates the configuration of a six-axis arm.
    #[must_use]
    pub const fn new(shoulder: Shoulder, elbow: Elbow, wrist: Wrist) -> Self {
        Self { shoulder, elbow, wrist }
    }

    /// Creates the configuration of a SCARA arm.
    #[must_use]
    pub const fn scara(shoulder: Shoulder) -> Self {
        Self::new(shoulder, Elbow::Positive, Wrist::Positive)
    }
}

/// Requested value for a field of a configuration.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum ConfigurationRequest<T> {
    /// `sfree`, `efree`, `wfree`: any value.
    #[default]
    Free,
    /// `ssame`, `esame`, `wsame`: the start value.
    Same,
    /// This value.
    Exactly(T),
}

impl<T: PartialEq> ConfigurationRequest<T> {
    fn allows(&self, value: &T, start: &T) -> bool {
        match self {
            Self::Free => true,
            Self::Same => value == start,
            Self::Exactly(requested) => value == requested,
        }
    }
}

/// Requested configuration at a Cartesian target.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub struct RequestedConfiguration {
    /// Shoulder.
    pub shoulder: ConfigurationRequest<Shoulder>,
    /// Elbow; ignored by SCARA arms.
    pub elbow: ConfigurationRequest<Elbow>,
    /// Wrist; ignored by SCARA arms.
    pub wrist: ConfigurationRequest<Wrist>,
}

impl RequestedConfiguration {
    /// Any configuration.
    pub const FREE: Self = Self {
        shoulder: ConfigurationRequest::Free,
        elbow: ConfigurationRequest::Free,
        wrist: ConfigurationRequest::Free,
    };

    /// The start configuration.
    pub const SAME: Self = Self {
        shoulder: ConfigurationRequest::Same,
        elbow: ConfigurationRequest::Same,
        wrist: ConfigurationRequest::Same,
    };

    /// Whether a move from the configuration `start` may end in `end`.
    #[must_use]
    pub fn allows(&self, end: Configuration, start: Configuration) -> bool {
        self.shoulder.allows(&end.shoulder, &start.shoulder)
            && self.elbow.allows(&end.elbow, &start.elbow)
            && self.wrist.allows(&end.wrist, &start.wrist)
    }
}

impl From<Configuration> for RequestedConfiguration {
    fn from(exact: Configuration) -> Self {
        Self {
            shoulder: ConfigurationRequest::Exactly(exact.shoulder),
            elbow: ConfigurationRequest::Exactly(exact.elbow),
            wrist: ConfigurationRequest::Exactly(exact.wrist),
        }
    }
}
