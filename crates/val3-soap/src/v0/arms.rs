//! Descriptions of arms.

use crate::structure::{enumeration, structure};

structure! {
    /// Arm of a controller.
    RobotDescription {
        /// Kind of the arm.
        kinematic: Kinematic = "kinematic",
        /// Model, for example `tx2-60`.
        arm: Option<String> = "arm",
        /// Tuning, for example `R1`.
        tuning: Option<String> = "tuning",
        /// Mounting.
        mount: MountType = "mountType",
        /// Stroke of the third axis of a SCARA arm.
        length_axis_3: LengthAxis3 = "lengthAxis3",
        /// Diameter of the third axis of a SCARA arm.
        diameter_axis_3: DiameterAxis3 = "diameterAxis3",
    }
}

enumeration! {
    /// Kinematic structure.
    Kinematic {
        /// No kind.
        Invalid = "KINEMATIC-INVALID",
        /// Six rotary joints.
        Anthropomorph6 = "KINEMATIC-ANTHROPOMORPH6",
        /// Five rotary joints.
        Anthropomorph5 = "KINEMATIC-ANTHROPOMORPH5",
        /// SCARA.
        Scara = "KINEMATIC-SCARA",
        /// Arm for painting.
        Eisenmann = "KINEMATIC-EISENMANN",
    }
}

enumeration! {
    /// Mounting position.
    MountType {
        /// No mounting.
        Invalid = "MOUNTTYPE-INVALID",
        /// On the floor.
        Floor = "MOUNTTYPE-FLOOR",
        /// On the ceiling.
        Ceiling = "MOUNTTYPE-CEILING",
        /// On a wall.
        Wall = "MOUNTTYPE-WALL",
    }
}

enumeration! {
    /// Stroke of the third axis of a SCARA arm.
    LengthAxis3 {
        /// No SCARA arm, or another stroke.
        Invalid = "LENGTHAXIS3-INVALID",
        /// 100 mm.
        L100 = "LENGTHAXIS3-L100",
        /// 200 mm.
        L200 = "LENGTHAXIS3-L200",
        /// 400 mm.
        L400 = "LENGTHAXIS3-L400",
        /// 600 mm.
        L600 = "LENGTHAXIS3-L600",
    }
}

enumeration! {
    /// Diameter of the third axis of a SCARA arm.
    DiameterAxis3 {
        /// No SCARA arm, or another diameter.
        Invalid = "DIAMETERAXIS3-INVALID",
        /// 20 mm.
        D20 = "DIAMETERAXIS3-D20",
        /// 25 mm.
        D25 = "DIAMETERAXIS3-D25",
    }
}
