//! States of signals.

use crate::structure::{choice, enumeration, structure};

structure! {
    /// State of a signal.
    SignalState {
        /// Whether the signal exists.
        status: SignalStatus = "state",
        /// Whether only a client can change the value.
        locked: bool = "locked",
        /// Whether the signal has no device.
        simulated: bool = "simulated",
        /// Value; 0 or 1 for a digital signal.
        value: f64 = "value",
        /// Description, if it was requested.
        description: Option<String> = "description",
        /// Conversion of the value.
        attributes: SignalAttributes = "attrib",
    }
}

enumeration! {
    /// Whether a signal exists.
    SignalStatus {
        /// The signal exists.
        Defined = "IO-DEFINED",
        /// There is no such signal.
        Undefined = "IO-UNDEFINED",
        /// The name is no name of a signal.
        InvalidName = "IO-INVALID-NAME",
    }
}

choice! {
    /// Conversion between the device and the value of a signal.
    SignalAttributes {
        /// Digital signal.
        Digital(DigitalAttributes) = "dioAttrib",
        /// Analogue signal.
        Analogue(AnalogueAttributes) = "aioAttrib",
    }
}

structure! {
    /// Conversion of a digital signal.
    DigitalAttributes {
        /// Whether the value is inverted.
        inverted: bool = "inverted",
    }
}

structure! {
    /// Analogue conversion: `a * x + b` (inferred).
    AnalogueAttributes {
        /// Factor.
        a: f64 = "coefA",
        /// Offset.
        b: f64 = "coefB",
    }
}

structure! {
    /// Result of writing, locking or unlocking a signal.
    SignalResponse {
        /// Whether the signal was changed.
        success: bool = "success",
        /// Whether the signal exists.
        found: bool = "found",
    }
}

structure! {
    /// Result of unlocking a signal.
    UnlockedSignal {
        /// Result.
        response: SignalResponse = "response",
        /// State afterwards.
        state: SignalState = "state",
    }
}
