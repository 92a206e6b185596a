//! Arm configurations (9.7) as program values.

use val3_kinematics::{Arm, Configuration, ConfigurationRequest, Elbow, RequestedConfiguration, Shoulder, Wrist};

/// A configuration: shoulder, elbow, wrist, each as an enumerator index.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ConfigValue(pub [f64; 3]);

/// Indexes of the enumerators, which are the same for shoulder, elbow and wrist.
const SAME: f64 = 0.0;
const FIRST: f64 = 2.0;
const SECOND: f64 = 3.0;

impl ConfigValue {
    /// Configuration of `arm` at a joint position. A SCARA arm has only a shoulder.
    #[must_use]
    pub fn at(arm: &Arm, joint: &[f64; 6]) -> Self {
        Self::of(arm.configuration(joint), arm.is_scara())
    }

    /// Value with exactly this configuration. A SCARA arm has only a shoulder.
    #[must_use]
    pub fn of(Configuration { shoulder, elbow, wrist }: Configuration, is_scara: bool) -> Self {
        let place = |is_first| if is_first { FIRST } else { SECOND };
        let shoulder = place(shoulder == Shoulder::Lefty);
        if is_scara {
            return Self([shoulder, SAME, SAME]);
        }
        Self([shoulder, place(elbow == Elbow::Positive), place(wrist == Wrist::Positive)])
    }

    /// Configurations that the value permits.
    #[must_use]
    pub fn requested(&self) -> RequestedConfiguration {
        let Self([shoulder, elbow, wrist]) = *self;
        RequestedConfiguration {
            shoulder: request(shoulder, [Shoulder::Lefty, Shoulder::Righty]),
            elbow: request(elbow, [Elbow::Positive, Elbow::Negative]),
            wrist: request(wrist, [Wrist::Positive, Wrist::Negative]),
        }
    }
}

fn request<T>(place: f64, [first, second]: [T; 2]) -> ConfigurationRequest<T> {
    match place {
        FIRST => ConfigurationRequest::Exactly(first),
        SECOND => ConfigurationRequest::Exactly(second),
        SAME => ConfigurationRequest::Same,
        _ => ConfigurationRequest::Free,
    }
}

#[cfg(test)]
mod tests {
    use val3_kinematics::{ConfigurationRequest, Shoulder, Wrist};

    use super::ConfigValue;
    use crate::enumerations::values;
    use crate::types::BaseType;

    #[test]
    fn the_places_are_those_of_the_enumerations() {
        let places =
            |ty, wanted: [&str; 4]| wanted.map(|name| values(ty).position(|row| row.name == name).unwrap() as f64);
        assert_eq!(places(BaseType::Shoulder, ["ssame", "sfree", "lefty", "righty"]), [0.0, 1.0, 2.0, 3.0]);
        assert_eq!(places(BaseType::Elbow, ["esame", "efree", "epositive", "enegative"]), [0.0, 1.0, 2.0, 3.0]);
        assert_eq!(places(BaseType::Wrist, ["wsame", "wfree", "wpositive", "wnegative"]), [0.0, 1.0, 2.0, 3.0]);
        let requested = ConfigValue([3.0, 0.0, 2.0]).requested();
        assert_eq!(requested.shoulder, ConfigurationRequest::Exactly(Shoulder::Righty));
        assert_eq!(
            (requested.elbow, requested.wrist),
            (ConfigurationRequest::Same, ConfigurationRequest::Exactly(Wrist::Positive))
        );
        assert_eq!(ConfigValue([1.0; 3]).requested().shoulder, ConfigurationRequest::Free);
    }
}
