//! `getControllerParameters`: parameters of the controller, for example its serial number.

use super::ControllerParameter;
use crate::structure::{operation, structure};

structure! {
    /// Request `getControllerParameters`.
    GetControllerParameters {}
}

structure! {
    /// Answer of `getControllerParameters`.
    GetControllerParametersAnswer {
        /// Parameters.
        parameters: Vec<ControllerParameter> = "out" of "Parameters",
    }
}

operation!(GetControllerParameters: V0 "getControllerParameters" => GetControllerParametersAnswer, "getControllerParametersResponse");
