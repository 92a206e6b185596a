//! `getDefaultDH` (11.4.4): returns the nominal geometric parameters of this type of arm.

use crate::call::{Arr, Call};
use crate::declare::instruction;
use crate::fault::Result;
use crate::geometry_parameters;

instruction! {
    /// Returns the nominal geometric parameters of this type of arm.
    ///
    /// - `theta`, `alpha`, `beta`: receive the angles in degrees, one value per axis.
    /// - `d`, `a`: receive the lengths in millimetres, one value per axis.
    /// - Error 70: an array is too small.
    ///
    /// ## Example
    /// ```val3
    /// num nTheta[6]
    /// num nD[7]
    /// num nA[6]
    /// num nAlpha[6]
    /// num nBeta[6]
    ///   getDefaultDH(nTheta,nD,nA,nAlpha,nBeta)
    ///   putln(nA[1])
    /// ```
    "getDefaultDH": Options "11.4.4", errors [70];
    modifier (num& theta[], num& d[], num& a[], num& alpha[], num& beta[]) = parameters;
}

fn parameters(
    call: &mut Call<'_>,
    theta: Arr<f64>,
    d: Arr<f64>,
    a: Arr<f64>,
    alpha: Arr<f64>,
    beta: Arr<f64>,
) -> Result<()> {
    let dh = call.ports.arm().default_dh();
    geometry_parameters::write(call, &dh, [theta, d, a, alpha, beta])
}
