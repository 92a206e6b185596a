//! `setDH` (11.4.4): changes the geometric parameters of the arm, immediately and in its configuration.

use crate::call::{Arr, Call, Flow, Wait};
use crate::declare::instruction;
use crate::fault::Result;
use crate::geometry_parameters;

instruction! {
    /// Changes the geometric parameters of the arm, immediately and in its configuration.
    ///
    /// - `theta`, `alpha`, `beta`: the angles in degrees; read only.
    /// - `d`, `a`, `b`: the lengths in millimetres; read only. One value per axis, and in `d` one more for the flange.
    /// - Result: `false` if they differ too much from the parameters of the arm type, or if an array has a wrong size.
    ///   Nothing is then changed.
    /// - Errors: 70 bad arrays, 250 no licence for an absolute robot.
    ///
    /// It waits until all moves are done.
    ///
    /// ## Example
    /// ```val3
    /// num nTheta[6]
    /// num nD[7]
    /// num nA[6]
    /// num nB[6]
    /// num nAlpha[6]
    /// num nBeta[6]
    ///   if setDH(nTheta,nD,nA,nB,nAlpha,nBeta)==false
    ///     logMsg("arm parameters refused")
    ///   endIf
    /// ```
    "setDH": Options "11.4.4", blocking, errors [70, 250];
    modifier (num& theta[], num& d[], num& a[], num& b[], num& alpha[], num& beta[]) -> bool = change;
}

fn change(
    call: &mut Call<'_>,
    theta: Arr<f64>,
    d: Arr<f64>,
    a: Arr<f64>,
    b: Arr<f64>,
    alpha: Arr<f64>,
    beta: Arr<f64>,
) -> Result<Flow<bool>> {
    if !call.ports.is_empty() {
        return Ok(Flow::Wait(Wait::FOR_OTHERS));
    }
    let Some(dh) = geometry_parameters::read(call, [theta, d, a, b, alpha, beta])? else {
        call.ports.log("setDH: the arrays need a value an axis, and d one more for the flange", ERROR_LEVEL);
        return Ok(Flow::Done(false));
    };
    call.ports.set_dh(&dh).map(Flow::Done)
}

/// Error level in `logMsg`.
const ERROR_LEVEL: f64 = 3.0;
