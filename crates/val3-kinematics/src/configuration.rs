//! Configurations (manual 9.7).

/// On which side of the arm the flange is.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Shoulder {
    /// `lefty`
    Lefty,
    /// `righty`
    Righty,
}

/// The sign of axis 3 of a six-axis arm.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Elbow {
    /// `epositive`: axis 3 is at 0 or more.
    Positive,
    /// `enegative`
    Negative,
}

/// The sign of axis 5 of a six-axis arm.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Wrist {
    /// `wpositive`: axis 5 is at 0 or more.
    Positive,
    /// `wnegative`
    Negative,
}

/// The configuration of a joint position. It identifies a branch of the inverse kinematics.
///
/// Elbow and wrist of a SCARA arm are always positive.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct Configuration {
    /// The shoulder.
    pub shoulder: Shoulder,
    /// The elbow.
    pub elbow: Elbow,
    /// The wrist.
    pub wrist: Wrist,
}

impl Configuration {
    /// The branches of a six-axis arm, in the order in which equally good ones are preferred.
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

    /// The branches of a SCARA arm.
    pub const SCARA: [Self; 2] = [Self::scara(Shoulder::Lefty), Self::scara(Shoulder::Righty)];

    /// The configuration of a six-axis arm.
    #[must_use]
    pub const fn new(shoulder: Shoulder, elbow: Elbow, wrist: Wrist) -> Self {
        Self { shoulder, elbow, wrist }
    }

    /// The configuration of a SCARA arm.
    #[must_use]
    pub const fn scara(shoulder: Shoulder) -> Self {
        Self::new(shoulder, Elbow::Positive, Wrist::Positive)
    }
}

/// A requested value of one field of a configuration.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum Request<T> {
    /// `sfree`, `efree`, `wfree`: any value.
    #[default]
    Free,
    /// `ssame`, `esame`, `wsame`: the value at the start.
    Same,
    /// This value.
    Exactly(T),
}

impl<T: PartialEq> Request<T> {
    fn allows(&self, value: &T, start: &T) -> bool {
        match self {
            Self::Free => true,
            Self::Same => value == start,
            Self::Exactly(requested) => value == requested,
        }
    }
}

/// The configuration of a Cartesian target.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub struct RequestedConfiguration {
    /// The shoulder.
    pub shoulder: Request<Shoulder>,
    /// The elbow. Ignored by SCARA arms.
    pub elbow: Request<Elbow>,
    /// The wrist. Ignored by SCARA arms.
    pub wrist: Request<Wrist>,
}

impl RequestedConfiguration {
    /// Any configuration.
    pub const FREE: Self = Self { shoulder: Request::Free, elbow: Request::Free, wrist: Request::Free };

    /// The configuration at the start.
    pub const SAME: Self = Self { shoulder: Request::Same, elbow: Request::Same, wrist: Request::Same };

    /// True if a move that starts in `start` may end in `end`.
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
            shoulder: Request::Exactly(exact.shoulder),
            elbow: Request::Exactly(exact.elbow),
            wrist: Request::Exactly(exact.wrist),
        }
    }
}
