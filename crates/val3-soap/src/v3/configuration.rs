//! Configurations of arms.

use crate::structure::{choice, enumeration, structure};

choice! {
    /// Arm configuration.
    ArmConfig {
        /// Arm with six rotary joints.
        Anthro(AnthroConfig) = "anthroConfig",
        /// SCARA arm.
        Scara(ScaraConfig) = "scaraConfig",
        /// Arm for painting.
        Vrbx(VrbxConfig) = "vrbxConfig",
    }
}

structure! {
    /// Configuration with six rotary joints.
    AnthroConfig {
        /// Shoulder.
        shoulder: Shoulder = "shoulder",
        /// Elbow.
        elbow: PositiveNegative = "elbow",
        /// Wrist.
        wrist: PositiveNegative = "wrist",
    }
}

structure! {
    /// Configuration of a SCARA arm.
    ScaraConfig {
        /// Shoulder.
        shoulder: Shoulder = "shoulder",
    }
}

structure! {
    /// Painting arm configuration.
    VrbxConfig {
        /// First joint.
        joint_1: AboveBelow = "jnt1",
        /// Third joint.
        joint_3: PositiveNegative = "jnt3",
        /// Fifth joint.
        joint_5: PositiveNegative = "jnt5",
    }
}

enumeration! {
    /// Configuration of a shoulder.
    Shoulder {
        /// The configuration before the move.
        Same = "SSAME",
        /// To the left.
        Lefty = "LEFTY",
        /// To the right.
        Righty = "RIGHTY",
        /// Any.
        Free = "SFREE",
    }
}

enumeration! {
    /// Elbow or wrist configuration.
    PositiveNegative {
        /// The configuration before the move.
        Same = "PNSAME",
        /// Positive angle.
        Positive = "POSITIVE",
        /// Negative angle.
        Negative = "NEGATIVE",
        /// Any.
        Free = "PNFREE",
    }
}

enumeration! {
    /// Configuration of joint 1 in painting arms.
    AboveBelow {
        /// The configuration before the move.
        Same = "ABSAME",
        /// Above.
        Above = "ABOVE",
        /// Below.
        Below = "BELOW",
        /// Any.
        Free = "ABFREE",
    }
}
